// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/radarscenes_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using testing::Floats;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ReadAll;
using testing::TempFolder;

constexpr char kNames[] =
    "scan,timestamp_rad,first_point,num_points,timestamp_odom,x,y,yaw,vx,yaw_rate\n";

class RadarScenesSourceTest : public ::testing::Test {
 protected:
  RadarScenesSourceTest() {
    options_.format = InputOptions::Format::kRadarScenes;
    options_.radar = "2";
    // 20 m straight ahead closing in at 10 m/s; 10 m to the left going away; behind.
    folder_.Write("radar2_points.bin",
                  Floats({20.0, 0.0, -10.0, 5.0, 11.0}) + Floats({10.0, M_PI_2, 2.0, -3.0, 0.0}) +
                      Floats({4.0, M_PI, 1.5, 0.0, 11.0}));
  }
  void WriteTable(const std::string& lines) { folder_.Write("radar2_scans.csv", kNames + lines); }
  std::unique_ptr<ScanSource> Open() {
    auto source = RadarScenesSource::Open(folder_.path(), options_, &error_);
    EXPECT_NE(source, nullptr) << error_;
    return source;
  }
  std::string OpenError() {
    EXPECT_EQ(RadarScenesSource::Open(folder_.path(), options_, &error_), nullptr);
    return error_;
  }

  TempFolder folder_;
  InputOptions options_;
  std::string error_;
};

TEST_F(RadarScenesSourceTest, ReadsScansInTheRadarFrame) {
  WriteTable("1,0.068314,0,2,0.07,1556.4,540.6,-0.17,20.6,0.01\n2,0.145249,2,1,0,0,0,0,0,0\n");
  const auto source = Open();
  EXPECT_EQ(source->NumScans(), 2);
  const auto scans = ReadAll(source.get());
  EXPECT_THAT(testing::Stamps(scans), ElementsAre(68314000, 145249000));
  EXPECT_TRUE(scans[0].has_doppler);
  EXPECT_TRUE(scans[0].is_planar);
  EXPECT_EQ(scans[0].radar, 2);
  EXPECT_EQ(scans[1].place, (folder_.path() / "radar2_scans.csv:3").string());
  ASSERT_EQ(scans[0].returns.size(), 2u);
  const RadarReturn& ahead = scans[0].returns[0];
  EXPECT_EQ(ahead.position, Eigen::Vector3d(20.0, 0.0, 0.0));
  EXPECT_EQ(ahead.doppler, -10.0);
  EXPECT_EQ(ahead.power, 5.0);
  const RadarReturn& left = scans[0].returns[1];
  EXPECT_NEAR((left.position - Eigen::Vector3d(0.0, 10.0, 0.0)).norm(), 0.0, 1e-5);
  EXPECT_EQ(left.doppler, 2.0);
  ASSERT_EQ(scans[1].returns.size(), 1u);
  EXPECT_NEAR(scans[1].returns[0].position.x(), -4.0, 1e-5);

  options_.doppler_sign = InputOptions::DopplerSign::kMinus;
  EXPECT_EQ(ReadAll(Open().get())[0].returns[0].doppler, 10.0);
}

TEST_F(RadarScenesSourceTest, TruthAndLabelsAreNotLookedAt) {
  WriteTable("1,0.068314,0,3,0.07,1556.4,540.6,-0.17,20.6,0.01\n");
  const auto with_truth = ReadAll(Open().get());
  WriteTable("1,0.068314,0,3,not,to,be,read,at,all\n");
  folder_.Write("radar2_points.bin",
                Floats({20.0, 0.0, -10.0, 5.0, 7.0}) + Floats({10.0, M_PI_2, 2.0, -3.0, 7.0}) +
                    Floats({4.0, M_PI, 1.5, 0.0, 7.0}));
  const auto without = ReadAll(Open().get());
  ASSERT_EQ(without.size(), 1u);
  ASSERT_EQ(without[0].returns.size(), with_truth[0].returns.size());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(without[0].returns[i].position, with_truth[0].returns[i].position);
    EXPECT_EQ(without[0].returns[i].doppler, with_truth[0].returns[i].doppler);
    EXPECT_EQ(without[0].returns[i].power, with_truth[0].returns[i].power);
  }
}

TEST_F(RadarScenesSourceTest, ColumnsAreFoundByName) {
  folder_.Write("radar2_scans.csv", "num_points, timestamp_rad ,first_point\r\n1,5,2\r\n0,6,3\r\n");
  const auto source = Open();
  const auto scans = ReadAll(source.get());
  EXPECT_THAT(testing::Stamps(scans), ElementsAre(5000000000, 6000000000));
  EXPECT_NEAR(scans[0].returns.at(0).position.x(), -4.0, 1e-5);
  EXPECT_TRUE(scans[1].returns.empty());
  // Rows 0 and 1 are of no scan; an empty scan is nothing to warn of.
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(HasSubstr("radar2_scans.csv:2: the rows before it end with 0, not 2")));
}

TEST_F(RadarScenesSourceTest, RowsThatTheFileDoesNotHaveAreAnError) {
  for (const char* range : {"2,2", "4,0", "0,4", "9223372036854775807,9223372036854775807"}) {
    WriteTable("1,0.1,0,3,0,0,0,0,0,0\n2,0.2," + std::string(range) + ",0,0,0,0,0,0\n");
    EXPECT_THAT(OpenError(),
                AllOf(HasSubstr((folder_.path() / "radar2_scans.csv:3").string()),
                      HasSubstr("beyond the 3 rows"),
                      HasSubstr("radar2_points.bin")))
        << range;
  }
  WriteTable("1,0.1,3,0,0,0,0,0,0,0\n");  // the end itself is no row too many
  EXPECT_TRUE(ReadAll(Open().get())[0].returns.empty());
}

TEST_F(RadarScenesSourceTest, WarnsWhenALineIsLost) {
  WriteTable("1,0.1,0,1,0,0,0,0,0,0\n2,0.2,1,2,0,0,0,0,0,0\n");
  EXPECT_THAT(Open()->TakeWarnings(), IsEmpty());
  WriteTable("1,0.1,0,1,0,0,0,0,0,0\n3,0.3,2,1,0,0,0,0,0,0\n");
  EXPECT_THAT(Open()->TakeWarnings(),
              ElementsAre(HasSubstr("radar2_scans.csv:3: the rows before it end with 1, not 2")));
  WriteTable("1,0.1,0,1,0,0,0,0,0,0\n");
  EXPECT_THAT(Open()->TakeWarnings(), ElementsAre(HasSubstr("end with 1, not 3 (1 such places)")));
}

TEST_F(RadarScenesSourceTest, LinesThatAreNoNumbersAreNamed) {
  for (const char* line : {"2,abc,0,1", "2,0.2,-1,1", "2,0.2,0,1.5", "2,0.2,0", "2,,0,1", "text"}) {
    WriteTable("1,0.1,0,3,0,0,0,0,0,0\n" + std::string(line) + "\n");
    EXPECT_THAT(OpenError(),
                AllOf(HasSubstr((folder_.path() / "radar2_scans.csv:3").string()),
                      HasSubstr("expected seconds in timestamp_rad"),
                      HasSubstr("'" + std::string(line) + "'")))
        << line;
  }
}

TEST_F(RadarScenesSourceTest, TableMustHaveNamesAndScans) {
  WriteTable("");
  EXPECT_THAT(OpenError(),
              AllOf(HasSubstr("radar2_scans.csv"), HasSubstr("expected a line a scan")));
  for (const char* names : {"",
                            "timestamp_rad,first_point\n0,0\n",
                            "timestamp_rad,first_point,num_points,num_points\n0,0,1,1\n"}) {
    folder_.Write("radar2_scans.csv", names);
    EXPECT_THAT(OpenError(), HasSubstr("radar2_scans.csv:1: expected the names of the columns"));
  }
}

TEST_F(RadarScenesSourceTest, BytesBehindTheLastRowAreIgnoredWithAWarning) {
  folder_.Write("radar2_points.bin", Floats({20.0, 0.0, -10.0, 5.0, 11.0}) + "abc");
  WriteTable("1,0.1,0,1,0,0,0,0,0,0\n");
  const auto source = Open();
  EXPECT_EQ(ReadAll(source.get())[0].returns.size(), 1u);
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(AllOf(HasSubstr("radar2_points.bin"),
                                HasSubstr("23 bytes is no multiple of 20"),
                                HasSubstr("last 3"))));
}

TEST_F(RadarScenesSourceTest, AFileThatShrinksMeanwhileEndsTheDrive) {
  WriteTable("1,0.1,0,3,0,0,0,0,0,0\n2,0.2,0,1,0,0,0,0,0,0\n");
  const auto source = Open();
  std::filesystem::resize_file(folder_.path() / "radar2_points.bin", 20);
  RadarScan scan;
  EXPECT_EQ(source->Next(&scan), ScanSource::Status::kError);
  EXPECT_THAT(source->error(),
              AllOf(HasSubstr("radar2_scans.csv:2"), HasSubstr("can no longer be read")));
}

TEST_F(RadarScenesSourceTest, AbsentFilesAreNamed) {
  WriteTable("1,0.1,0,3,0,0,0,0,0,0\n");
  options_.radar = "4";
  EXPECT_THAT(OpenError(),
              AllOf(HasSubstr((folder_.path() / "radar4_scans.csv").string()),
                    HasSubstr("input.radar"),
                    HasSubstr("found in the folder: radar2")));
  options_.radar = "2";
  folder_.Write("radar2_points.bin", testing::LfsPointer());
  EXPECT_THAT(OpenError(), HasSubstr("radar2_points.bin: a Git-LFS pointer"));
  std::filesystem::remove(folder_.path() / "radar2_points.bin");
  EXPECT_THAT(OpenError(), AllOf(HasSubstr("radar2_points.bin"), HasSubstr("cannot be opened")));
  options_.folder = "seq7";
  EXPECT_THAT(OpenError(),
              AllOf(HasSubstr((folder_.path() / "seq7").string()), HasSubstr("expected a folder")));
}

TEST_F(RadarScenesSourceTest, SkipsWithoutReading) {
  WriteTable("1,0.1,0,1,0,0,0,0,0,0\n2,0.2,1,1,0,0,0,0,0,0\n3,0.3,2,1,0,0,0,0,0,0\n");
  const auto source = Open();
  EXPECT_EQ(source->Skip(2), ScanSource::Status::kScan);
  RadarScan scan;
  ASSERT_EQ(source->Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(scan.stamp_ns, 300000000);
  EXPECT_NEAR(scan.returns.at(0).position.x(), -4.0, 1e-5);
  EXPECT_EQ(source->Skip(1), ScanSource::Status::kEnd);
}

}  // namespace
}  // namespace radive
