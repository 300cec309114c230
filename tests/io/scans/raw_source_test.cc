// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/raw_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using testing::Floats;
using ::testing::HasSubstr;
using testing::ReadAll;
using testing::TempFolder;

InputOptions AtTenHertz() {
  InputOptions options;
  options.rate = 10.0;
  return options;
}

class RawSourceTest : public ::testing::Test {
 protected:
  RawSourceTest() { options_.layout = "xyz3"; }

  // The source of the folder, which must open.
  std::unique_ptr<ScanSource> Open() {
    auto source = OpenRawSource(folder_.path(), options_, &error_);
    EXPECT_NE(source, nullptr) << error_;
    return source;
  }

  // What Open says of a folder that must not open.
  std::string OpenError() {
    EXPECT_EQ(OpenRawSource(folder_.path(), options_, &error_), nullptr);
    return error_;
  }

  TempFolder folder_;
  InputOptions options_ = AtTenHertz();
  std::string error_;
};

// 20 m ahead, 1 m to the left, 0.5 m up; closing in at 10 m/s.
TEST_F(RawSourceTest, ReturnAheadThatClosesInHasNegativeDoppler) {
  folder_.Write("0.bin", Floats({20.0, 1.0, 0.5, -10.0, 12.5}) + Floats({30, 2, 1, 4, 8}));
  options_.layout = "xyzdp5";
  const auto scans = ReadAll(Open().get());
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_TRUE(scans[0].has_doppler);
  EXPECT_FALSE(scans[0].is_planar);
  EXPECT_EQ(scans[0].place, (folder_.path() / "0.bin").string());
  ASSERT_EQ(scans[0].returns.size(), 2u);
  EXPECT_EQ(scans[0].returns[0].position, Eigen::Vector3d(20.0, 1.0, 0.5));
  EXPECT_EQ(scans[0].returns[0].doppler, -10.0);
  EXPECT_EQ(scans[0].returns[0].power, 12.5);
  EXPECT_EQ(scans[0].returns[1].position, Eigen::Vector3d(30.0, 2.0, 1.0));
  EXPECT_EQ(scans[0].returns[1].doppler, 4.0);
}

TEST_F(RawSourceTest, DopplerOfTheOtherSignIsTurned) {
  folder_.Write("0.bin", Floats({20.0, 0.0, 0.0, 10.0, 12.5}));
  options_.layout = "xyzdp5";
  options_.doppler_sign = InputOptions::DopplerSign::kMinus;
  EXPECT_EQ(ReadAll(Open().get())[0].returns[0].doppler, -10.0);
}

TEST_F(RawSourceTest, PicksTheDeclaredColumns) {
  // View-of-Delft: x y z RCS v_r v_r_compensated time.
  folder_.Write("0.bin", Floats({20.0, 1.0, 0.5, -7.0, -10.0, 0.25, -1.0}));
  options_.layout = "vod7";
  const RadarReturn vod = ReadAll(Open().get())[0].returns[0];
  EXPECT_EQ(vod.doppler, -10.0);
  EXPECT_EQ(vod.power, -7.0);
  // TJ4DRadSet: x y z v_r range power alpha beta.
  folder_.Write("0.bin", Floats({20.0, 1.0, 0.5, -10.0, 20.5, 17.0, -2.0, 1.0}));
  options_.layout = "tj4d8";
  const RadarReturn tj4d = ReadAll(Open().get())[0].returns[0];
  EXPECT_EQ(tj4d.doppler, -10.0);
  EXPECT_EQ(tj4d.power, 17.0);
}

TEST_F(RawSourceTest, WithoutADopplerColumnThereIsNoDoppler) {
  folder_.Write("0.bin", Floats({20.0, 1.0, 0.5}));
  const auto scans = ReadAll(Open().get());
  EXPECT_FALSE(scans[0].has_doppler);
  EXPECT_TRUE(std::isnan(scans[0].returns[0].doppler));
  EXPECT_TRUE(std::isnan(scans[0].returns[0].power));
}

TEST_F(RawSourceTest, PlanarSensorsHaveNoHeight) {
  folder_.Write("0.bin", Floats({20.0, 1.0, 0.5}));
  options_.planar = true;
  auto scans = ReadAll(Open().get());
  EXPECT_TRUE(scans[0].is_planar);
  EXPECT_EQ(scans[0].returns[0].position, Eigen::Vector3d(20.0, 1.0, 0.0));

  options_.planar = false;
  options_.layout = "x,y,doppler";
  scans = ReadAll(Open().get());
  EXPECT_TRUE(scans[0].is_planar);
  EXPECT_EQ(scans[0].returns[0].position, Eigen::Vector3d(20.0, 1.0, 0.0));
  EXPECT_EQ(scans[0].returns[0].doppler, 0.5);
}

TEST_F(RawSourceTest, FilesAreInTheOrderOfTheirNumbers) {
  for (const int k : {10, 9, 100, 2}) {
    folder_.Write(std::to_string(k) + ".bin", Floats({double(k), 0.0, 0.0}));
  }
  folder_.Write("notes.txt", "no scan");
  folder_.Write("._2.bin", "left by another system");
  const auto source = Open();
  EXPECT_EQ(source->NumScans(), 4);
  EXPECT_THAT(testing::FirstX(ReadAll(source.get())), ElementsAre(2.0, 9.0, 10.0, 100.0));
}

TEST_F(RawSourceTest, StampsAreThePositionOverTheRate) {
  for (int k = 0; k < 7; ++k) folder_.Write(std::to_string(1803 + k) + ".bin", "");
  EXPECT_THAT(testing::Stamps(ReadAll(Open().get())),
              ElementsAre(0, 100000000, 200000000, 300000000, 400000000, 500000000, 600000000));
  options_.rate = 15.0;
  EXPECT_THAT(testing::Stamps(ReadAll(Open().get())),
              ElementsAre(0, 66666667, 133333333, 200000000, 266666667, 333333333, 400000000));
}

TEST_F(RawSourceTest, ARateThatIsAssumedIsWarnedOf) {
  for (int k = 0; k < 2; ++k) folder_.Write(std::to_string(k) + ".bin", Floats({1, 2, 3}));
  options_.rate = 0.0;
  const auto source = Open();
  EXPECT_THAT(testing::Stamps(ReadAll(source.get())), ElementsAre(0, 100000000));
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(HasSubstr("the scans have no stamps; 10 scans per second are assumed")));
}

TEST_F(RawSourceTest, TimesFileGivesTheStampsAsTheyAre) {
  for (int k = 0; k < 4; ++k) folder_.Write("radar/" + std::to_string(k) + ".bin", "");
  // A repeated stamp and one that goes back: passed on, odometry decides.
  folder_.Write("times.txt", "0.1\n0.25\n0.25\n0.2\n");
  EXPECT_THAT(testing::Stamps(ReadAll(Open().get())),
              ElementsAre(100000000, 250000000, 250000000, 200000000));
  // The one beside the scans comes first.
  folder_.Write("radar/times.txt", "100000005\n200000006\n300000007\n400000008\n");
  const auto source = Open();
  EXPECT_THAT(testing::Stamps(ReadAll(source.get())),
              ElementsAre(100000005, 200000006, 300000007, 400000008));
  EXPECT_THAT(source->Description(), HasSubstr("stamps from times.txt"));
}

TEST_F(RawSourceTest, TimesFileOfAnotherLengthIsAnError) {
  for (int k = 0; k < 3; ++k) folder_.Write(std::to_string(k) + ".bin", "");
  folder_.Write("times.txt", "0.1\n0.2\n");
  EXPECT_THAT(OpenError(),
              AllOf(HasSubstr((folder_.path() / "times.txt").string()),
                    HasSubstr("has 2 stamps, expected one for each of the 3 scans")));
}

// ColoRadar: data/ holds the scans, timestamps.txt lies above it.
TEST_F(RawSourceTest, TimestampsMayLieAboveTheScans) {
  for (int k = 0; k < 2; ++k) {
    folder_.Write("clouds/data/radar_pointcloud_" + std::to_string(9 + k) + ".bin",
                  Floats({double(k), 0, 0}));
  }
  folder_.Write("clouds/timestamps.txt", "1608606283.100000000\n1608606283.200000000\n");
  options_.folder = "clouds/data";
  const auto scans = ReadAll(Open().get());
  EXPECT_THAT(testing::FirstX(scans), ElementsAre(0.0, 1.0));
  EXPECT_THAT(testing::Stamps(scans), ElementsAre(1608606283100000000, 1608606283200000000));
}

// Doppler-ICP: the stamps are the first column of a trajectory.
TEST_F(RawSourceTest, ReferencePosesGiveStamps) {
  for (int k = 0; k < 2; ++k) folder_.Write("point_clouds/0000" + std::to_string(k) + ".bin", "");
  folder_.Write("ref_poses.txt", "# t x y z\n0 0 0 0 0 0 0 1\n0.1 1 0 0 0 0 0 1\n");
  options_.folder = "point_clouds";
  EXPECT_THAT(testing::Stamps(ReadAll(Open().get())), ElementsAre(0, 100000000));
}

TEST_F(RawSourceTest, AFolderFurtherDownIsFound) {
  folder_.Write("unpacked/here/LiDAR/Aeva/7.bin", Floats({7, 0, 0}));
  options_.folder = "LiDAR/Aeva";
  EXPECT_THAT(testing::FirstX(ReadAll(Open().get())), ElementsAre(7.0));
}

TEST_F(RawSourceTest, OneFileIsADriveOfOneScan) {
  folder_.Write("0.bin", Floats({1, 2, 3}));
  folder_.Write("1693922345123456789.bin", Floats({4, 5, 6}));
  const auto source = OpenRawSource(folder_.path() / "1693922345123456789.bin", options_, &error_);
  ASSERT_NE(source, nullptr) << error_;
  const auto scans = ReadAll(source.get());
  EXPECT_THAT(testing::FirstX(scans), ElementsAre(4.0));
  EXPECT_EQ(scans[0].stamp_ns, 1693922345123456789);
}

// What the documentation of each dataset says of its columns: x is 20, the Doppler -10, power 30.
TEST_F(RawSourceTest, PicksTheColumnsOfEachDataset) {
  const std::pair<const char*, std::string> cases[] = {
      {"mscrad17", Floats({20, 0, 0, 0, 0, 0, 0, 1, 2, 20, -10, 30, 99, 1, 0, 0, 0})},
      {"coloradar5", Floats({20, 0, 0, 30, -10})},
      {"dualradar5", Floats({20, 0, 0, 30, -10})},
      {"boreas_aeva7", Floats({20, 0, 0, 30, -10, 3, 0.1})},
      {"boreas_aeva40", Floats({20, 0, 0, -10, 30, 1, 2, 0.1}) + std::string(8, '\x01')},
      {"hercules29", Floats({20, 0, 0, -10, 20}) + '\x1E' + Floats({0, 0})},
  };
  for (const auto& [layout, record] : cases) {
    folder_.Write("0.bin", record);
    options_.layout = layout;
    const auto source = Open();
    const RadarReturn only = ReadAll(source.get()).at(0).returns.at(0);
    EXPECT_EQ(only.position, Eigen::Vector3d(20, 0, 0)) << layout;
    EXPECT_EQ(only.doppler, -10.0) << layout;
    EXPECT_EQ(only.power, 30.0) << layout;
    EXPECT_TRUE(source->TakeWarnings().empty()) << layout;
  }
}

TEST_F(RawSourceTest, NamesThatAreStampsAreUsed) {
  folder_.Write("1693922345123456790.bin", "");
  folder_.Write("1693922345123456789.bin", "");
  EXPECT_THAT(testing::Stamps(ReadAll(Open().get())),
              ElementsAre(1693922345123456789, 1693922345123456790));
  folder_.Write("17.bin", "");
  EXPECT_THAT(OpenError(), AllOf(HasSubstr("17.bin"), HasSubstr("no stamp")));
}

TEST_F(RawSourceTest, BytesBehindTheLastRecordAreIgnoredWithAWarning) {
  folder_.Write("0.bin", Floats({1.0, 2.0, 3.0, 4.0}) + "x");
  folder_.Write("1.bin", Floats({5.0, 6.0, 7.0}));
  const auto source = Open();
  const auto scans = ReadAll(source.get());
  EXPECT_EQ(scans[0].returns.size(), 1u);
  EXPECT_EQ(scans[1].returns.size(), 1u);
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(AllOf(HasSubstr((folder_.path() / "0.bin").string()),
                                HasSubstr("17 bytes is no multiple of 12 (layout xyz3)"),
                                HasSubstr("last 5"))));
  EXPECT_TRUE(source->TakeWarnings().empty());
}

TEST_F(RawSourceTest, ValuesThatAreNoNumbersArePassedOn) {
  const double inf = std::numeric_limits<double>::infinity();
  folder_.Write("0.bin", Floats({std::nan(""), 2.0, 3.0, inf, -inf}));
  options_.layout = "xyzdp5";
  const RadarReturn only = ReadAll(Open().get())[0].returns.at(0);
  EXPECT_TRUE(std::isnan(only.position.x()));
  EXPECT_EQ(only.doppler, inf);
  EXPECT_EQ(only.power, -inf);
}

TEST_F(RawSourceTest, FilesThatCannotBeReadAreEmptyScansWithAWarning) {
  folder_.Write("0.bin", Floats({1.0, 2.0, 3.0}));
  folder_.Write("1.bin", testing::LfsPointer());
  folder_.Write("2.bin", "");
  folder_.Write("3.bin", "");
  folder_.Write("4.bin", Floats({4.0, 5.0, 6.0}));
  const auto source = Open();
  const auto scans = ReadAll(source.get());
  EXPECT_THAT(testing::FirstX(scans), ElementsAre(1.0, -1.0, -1.0, -1.0, 4.0));
  EXPECT_EQ(scans[4].stamp_ns, 400000000);
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(AllOf(HasSubstr("1.bin: a Git-LFS pointer"), HasSubstr("empty scan"))));
}

TEST_F(RawSourceTest, AFolderOfPointersDoesNotOpen) {
  folder_.Write("0.bin", testing::LfsPointer());
  folder_.Write("1.bin", testing::LfsPointer());
  EXPECT_THAT(OpenError(), AllOf(HasSubstr(folder_.string()), HasSubstr("git lfs pull")));
}

TEST_F(RawSourceTest, SkipsWithoutReading) {
  for (int k = 0; k < 5; ++k) folder_.Write(std::to_string(k) + ".bin", Floats({1.0 * k, 0, 0}));
  folder_.Write("1.bin", "odd");
  const auto source = Open();
  EXPECT_EQ(source->Skip(3), ScanSource::Status::kScan);
  RadarScan scan;
  ASSERT_EQ(source->Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(scan.stamp_ns, 300000000);
  EXPECT_EQ(scan.returns.at(0).position.x(), 3.0);
  EXPECT_TRUE(source->TakeWarnings().empty());
  EXPECT_EQ(source->Skip(1), ScanSource::Status::kScan);
  EXPECT_EQ(source->Next(&scan), ScanSource::Status::kEnd);
  EXPECT_EQ(source->Skip(0), ScanSource::Status::kScan);
  EXPECT_EQ(source->Skip(1), ScanSource::Status::kEnd);
}

TEST_F(RawSourceTest, FindsTheUsualFolders) {
  for (const char* place : {"radar", "velodyne", "training/velodyne", "radar/training/velodyne"}) {
    const TempFolder drive;
    drive.Write(std::string(place) + "/00007.bin", Floats({7.0, 0.0, 0.0}));
    drive.Write("label_2/00007.txt", "Car");
    const auto source = OpenRawSource(drive.path(), options_, &error_);
    ASSERT_NE(source, nullptr) << error_;
    EXPECT_THAT(testing::FirstX(ReadAll(source.get())), ElementsAre(7.0));
  }
}

TEST_F(RawSourceTest, SeveralFoldersNeedAChoice) {
  folder_.Write("radar/0.bin", Floats({1.0, 0.0, 0.0}));
  folder_.Write("velodyne/0.bin", Floats({2.0, 0.0, 0.0}));
  EXPECT_THAT(OpenError(),
              AllOf(HasSubstr((folder_.path() / "radar").string()),
                    HasSubstr((folder_.path() / "velodyne").string()),
                    HasSubstr("input.folder")));
  options_.folder = "velodyne";
  EXPECT_THAT(testing::FirstX(ReadAll(Open().get())), ElementsAre(2.0));
  options_.folder = "lidar";
  EXPECT_THAT(OpenError(), AllOf(HasSubstr(folder_.string()), HasSubstr("in one of: lidar/")));
}

TEST_F(RawSourceTest, EmptyFolderSaysWhatWasLookedFor) {
  EXPECT_THAT(OpenError(),
              AllOf(HasSubstr(folder_.string()),
                    HasSubstr("expected *.bin files"),
                    HasSubstr("itself, radar/, velodyne/")));
}

// 4 and 7 are missing: the scans behind them keep their times.
TEST_F(RawSourceTest, AMissingNumberKeepsItsTime) {
  for (const int k : {2, 3, 5, 6, 8, 9})
    folder_.Write(std::to_string(k) + ".bin", Floats({1, 2, 3}));
  options_.rate = 10.0;
  const auto source = Open();
  EXPECT_THAT(testing::Stamps(ReadAll(source.get())),
              ElementsAre(0, 100000000, 300000000, 400000000, 600000000, 700000000));
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(HasSubstr("3.bin: 2 of the numbers in the file names are missing")));
}

TEST_F(RawSourceTest, ATimesFileThatLeadsNowhereIsAnError) {
  for (const int k : {0, 1}) folder_.Write(std::to_string(k) + ".bin", Floats({1, 2, 3}));
  std::filesystem::create_symlink("nowhere.txt", folder_.path() / "times.txt");
  std::string error;
  EXPECT_EQ(OpenRawSource(folder_.path(), options_, &error), nullptr);
  EXPECT_THAT(error, HasSubstr("times.txt: cannot be opened"));
}

}  // namespace
}  // namespace radive
