// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <glog/logging.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/io/datasets/dataset.h"
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

constexpr char kStamp[] = "1693922345123456789";

// One record of 29 bytes: x y z v r, RCS as one byte, azimuth, elevation.
std::string Record(double x, double y, double z, double v, double r, int rcs) {
  return Floats({x, y, z, v, r}) + static_cast<char>(rcs) + Floats({0.0, 0.0});
}

const Dataset& HerculesRow() {
  for (const Dataset& dataset : Datasets()) {
    if (dataset.name == "HeRCULES") return dataset;
  }
  LOG(FATAL) << "there is no HeRCULES";
}

class HerculesSourceTest : public ::testing::Test {
 protected:
  std::unique_ptr<ScanSource> Open() {
    auto source = HerculesRow().sensors[0].open(folder_.path(), options_, &error_);
    EXPECT_NE(source, nullptr) << error_;
    return source;
  }
  std::string OpenError() {
    EXPECT_EQ(HerculesRow().sensors[0].open(folder_.path(), options_, &error_), nullptr);
    return error_;
  }
  void WriteScan(const std::string& stem, const std::string& content) {
    folder_.Write("Radar/Continental/" + stem + ".bin", content);
  }

  TempFolder folder_;
  InputOptions options_;
  std::string error_;
};

TEST_F(HerculesSourceTest, ReadsPackedRecords) {
  WriteScan(kStamp, Record(3.0, 4.0, 12.0, -10.0, 13.0, -5) + Record(8, 0, 6, 2.5, 10, 100));
  const auto source = Open();
  const auto scans = ReadAll(source.get());
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_EQ(scans[0].stamp_ns, 1693922345123456789);
  EXPECT_TRUE(scans[0].has_doppler);
  EXPECT_FALSE(scans[0].is_planar);
  ASSERT_EQ(scans[0].returns.size(), 2u);
  EXPECT_EQ(scans[0].returns[0].position, Eigen::Vector3d(3.0, 4.0, 12.0));
  EXPECT_EQ(scans[0].returns[0].doppler, -10.0);
  EXPECT_EQ(scans[0].returns[0].power, -5.0);  // as unsigned it would be 251
  EXPECT_EQ(scans[0].returns[1].position, Eigen::Vector3d(8.0, 0.0, 6.0));
  EXPECT_EQ(scans[0].returns[1].doppler, 2.5);
  EXPECT_EQ(scans[0].returns[1].power, 100.0);
  EXPECT_THAT(source->TakeWarnings(), IsEmpty());

  options_.doppler_sign = InputOptions::DopplerSign::kMinus;
  EXPECT_EQ(ReadAll(Open().get())[0].returns[0].doppler, 10.0);
}

TEST_F(HerculesSourceTest, ScansAreInTheOrderOfTheirStamps) {
  WriteScan("1693922345200000000", Record(2, 0, 0, 0, 2, 0));
  WriteScan("999922345100000000", Record(1, 0, 0, 0, 1, 0));
  WriteScan("1693922345150000000", "");
  const auto scans = ReadAll(Open().get());
  EXPECT_THAT(testing::Stamps(scans),
              ElementsAre(999922345100000000, 1693922345150000000, 1693922345200000000));
  EXPECT_THAT(testing::FirstX(scans), ElementsAre(1.0, -1.0, 2.0));
}

TEST_F(HerculesSourceTest, AlienBytesAreNoticed) {
  WriteScan(kStamp, Record(3, 4, 0, -10, 5, 0) + "tail");
  const auto tail = Open();
  EXPECT_EQ(ReadAll(tail.get())[0].returns.size(), 1u);
  EXPECT_THAT(tail->TakeWarnings(),
              ElementsAre(AllOf(HasSubstr("33 bytes is no multiple of 29"), HasSubstr("last 4"))));
  WriteScan(kStamp, Record(3, 4, 0, -10, 7, 0));
  const auto misaligned = Open();
  EXPECT_EQ(ReadAll(misaligned.get())[0].returns.size(), 1u);
  EXPECT_THAT(misaligned->TakeWarnings(),
              ElementsAre(AllOf(HasSubstr(kStamp), HasSubstr("range is not |x y z| in 1 of 1"))));
}

TEST_F(HerculesSourceTest, FindsTheFolderWhereverItWasUnpacked) {
  folder_.Write("Continental_data/Radar/Continental/" + std::string(kStamp) + ".bin",
                Record(3, 4, 0, -10, 5, 0));
  folder_.Write("Radar/Continentalobject/" + std::string(kStamp) + ".bin", Floats({1, 2, 3, 4, 5}));
  folder_.Write("LiDAR/Aeva/" + std::string(kStamp) + ".bin", "aeva");
  EXPECT_THAT(testing::FirstX(ReadAll(Open().get())), ElementsAre(3.0));
  folder_.Write("again/Continental/" + std::string(kStamp) + ".bin", Record(6, 8, 0, -10, 10, 0));
  EXPECT_THAT(OpenError(), HasSubstr("input.folder"));
  options_.folder = "again/Continental";
  EXPECT_THAT(testing::FirstX(ReadAll(Open().get())), ElementsAre(6.0));
}

TEST_F(HerculesSourceTest, NamesMustBeStamps) {
  WriteScan("calibration", "no scan: the name has letters");
  EXPECT_THAT(OpenError(),
              AllOf(HasSubstr(folder_.string()),
                    HasSubstr("<stamp in nanoseconds>.bin"),
                    HasSubstr("Radar/Continental/"),
                    HasSubstr("any Continental/ below")));
  WriteScan("000012", Record(3, 4, 0, -10, 5, 0));
  EXPECT_THAT(OpenError(), AllOf(HasSubstr("000012.bin"), HasSubstr("19 digits")));
  folder_.Write("times.txt", "1693922345.123456789\n");
  EXPECT_THAT(testing::Stamps(ReadAll(Open().get())), ElementsAre(1693922345123456789));
}

// x y z reflectivity velocity, time as int32, line as uint8, and in the longer form intensity.
TEST_F(HerculesSourceTest, AevaRecordsHaveTwoSizes) {
  const std::string start = Floats({20, 1, 0.5, 30, -10}) + std::string("\x01\x00\x00\x00\x07", 5);
  const std::string longer = start + Floats({55});
  const std::string early = "1691936557946849179";
  const std::string late = "1691936557946849180";
  // 25 * 29 bytes are both: the stamp decides.
  std::string both;
  for (int i = 0; i < 29; ++i) both += start;
  folder_.Write("LiDAR/Aeva/" + early + ".bin", both);
  folder_.Write("LiDAR/Aeva/" + late + ".bin", longer + longer);
  options_.layout = "aeva";
  const auto source = HerculesRow().sensors[1].open(folder_.path(), options_, &error_);
  ASSERT_NE(source, nullptr) << error_;
  const auto scans = ReadAll(source.get());
  ASSERT_EQ(scans[0].returns.size(), 29u);
  EXPECT_EQ(scans[0].returns[28].doppler, -10.0);
  EXPECT_EQ(scans[0].returns[28].power, 30.0);  // no intensity: the reflectivity
  ASSERT_EQ(scans[1].returns.size(), 2u);
  EXPECT_EQ(scans[1].returns[1].position, Eigen::Vector3d(20.0, 1.0, 0.5));
  EXPECT_EQ(scans[1].returns[1].doppler, -10.0);
  EXPECT_EQ(scans[1].returns[1].power, 55.0);
  EXPECT_TRUE(source->TakeWarnings().empty());
}

}  // namespace
}  // namespace radive
