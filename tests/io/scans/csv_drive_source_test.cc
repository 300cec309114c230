// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/csv_drive_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ReadAll;

class CsvDriveSourceTest : public ::testing::Test {
 protected:
  std::unique_ptr<CsvDriveSource> Open(const std::string& text) {
    folder_.Write("drive.csv", text);
    return CsvDriveSource::Open(folder_.path() / "drive.csv", options_);
  }

  const testing::TempFolder folder_;
  InputOptions options_;
};

// The scan at 10.1 s is stored in two parts, the second behind that at 10.2 s, which is stored
// before all others.
TEST_F(CsvDriveSourceTest, SplitsByTimeInTheOrderOfTheStamps) {
  const auto source = Open(
      "time,x,y,z,doppler\n"
      "10.2,7,0,0,-1\n10.2,8,0,0,-1\n10.2,9,0,0,-1\n"
      "10.0,1,0,0,-1\n10.0,2,0,0,-1\n10.0,3,0,0,-1\n"
      "10.1,4,0,0,-1\n10.1,5,0,0,-1\n"
      "10.3,10,0,0,-1\n10.3,11,0,0,-1\n10.3,12,0,0,-1\n"
      "10.1,6,0.5,0.25,-1.5\n");
  ASSERT_NE(source, nullptr);
  EXPECT_EQ(source->NumScans(), 4);
  EXPECT_THAT(source->Description(),
              AllOf(HasSubstr("CSV table of 4 scans by its column 'time'"),
                    HasSubstr("stamps from column time (s)")));
  const auto scans = ReadAll(source.get());
  ASSERT_EQ(scans.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(scans[k].stamp_ns, 10000000000 + static_cast<std::int64_t>(k) * 100000000);
    EXPECT_TRUE(scans[k].has_doppler);
    ASSERT_EQ(scans[k].returns.size(), 3u);
    EXPECT_EQ(scans[k].returns[0].position.x(), 3.0 * static_cast<double>(k) + 1.0);
  }
  EXPECT_EQ(scans[1].returns[2].position, Eigen::Vector3d(6, 0.5, 0.25));
  EXPECT_EQ(scans[1].returns[2].doppler, -1.5);
  EXPECT_THAT(scans[1].place, HasSubstr("drive.csv: time 10.1"));
  EXPECT_THAT(source->TakeWarnings(), IsEmpty());
}

// Numbers of scans tell their order, by value, and input.rate their stamps.
TEST_F(CsvDriveSourceTest, FramesFollowTheRate) {
  options_.rate = 20.0;
  const auto source =
      Open("frame,x,y\n10,5,0\n10,6,0\n10,7,0\n9,1,0\n9,2,0\n9,3,0\n11,8,0\n11,9,0\n11,10,0\n");
  ASSERT_NE(source, nullptr);
  RadarScan scan;
  ASSERT_EQ(source->PassOver(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(scan.stamp_ns, 0);
  ASSERT_EQ(source->Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(scan.stamp_ns, 50000000);
  ASSERT_EQ(scan.returns.size(), 3u);
  EXPECT_EQ(scan.returns[0].position.x(), 5.0);
  EXPECT_FALSE(scan.has_doppler);
  EXPECT_TRUE(scan.is_planar);
  EXPECT_THAT(source->Facts().stamps_ns, ElementsAre(0, 50000000, 100000000));
  ASSERT_EQ(source->Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(source->Next(&scan), ScanSource::Status::kEnd);
}

// Frames 3, 4, 5 and 7 at 10 Hz, which is assumed.
TEST_F(CsvDriveSourceTest, AnAssumedRateIsAWarningAndMissingFramesAreTime) {
  const auto source = Open(
      "frame,x,y\n3,5,0\n3,6,0\n3,7,0\n4,1,0\n4,2,0\n4,3,0\n5,8,0\n5,9,0\n5,10,0\n"
      "7,8,0\n7,9,0\n7,10,0\n");
  ASSERT_NE(source, nullptr);
  EXPECT_THAT(source->Facts().stamps_ns, ElementsAre(0, 100000000, 200000000, 400000000));
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(HasSubstr("drive.csv: the scans have no stamps; 10 scans per second are "
                                    "assumed; set input.rate")));
}

// Times of single points: that of the first one of each frame.
TEST_F(CsvDriveSourceTest, FramesBesideTimesHaveThese) {
  const auto source = Open(
      "frame,timestamp_s,x,y\n0,5.00,5,0\n0,5.01,6,0\n0,5.02,7,0\n1,5.05,1,0\n1,5.06,2,0\n"
      "1,5.07,3,0\n2,5.10,8,0\n2,5.11,9,0\n2,5.12,10,0\n");
  ASSERT_NE(source, nullptr);
  EXPECT_THAT(source->Facts().stamps_ns, ElementsAre(5000000000, 5050000000, 5100000000));
  EXPECT_THAT(source->TakeWarnings(), IsEmpty());
}

// Points that were measured within a scan are none of a drive, nor is one that cannot be read.
TEST_F(CsvDriveSourceTest, OtherTablesAreNoDrive) {
  std::string text = "t,x,y\n";
  for (int i = 0; i < 9; ++i) text += std::to_string(i / 3 * 2000) + "e-7,1,2\n";  // 0.2 ms apart
  EXPECT_EQ(Open(text), nullptr);
  EXPECT_EQ(Open("x,y\n1,2\n3,4\n"), nullptr);
  EXPECT_EQ(CsvDriveSource::Open(folder_.path() / "absent.csv", options_), nullptr);
}

TEST_F(CsvDriveSourceTest, ColumnsThatGiveNoPointsAreAnError) {
  options_.fields = "[doppler=v_none]";
  const auto source = Open("frame,x,y\n1,1,0\n1,2,0\n1,3,0\n2,1,0\n2,2,0\n2,3,0\n");
  ASSERT_NE(source, nullptr);
  RadarScan scan;
  EXPECT_EQ(source->Next(&scan), ScanSource::Status::kError);
  EXPECT_THAT(source->error(), AllOf(HasSubstr("drive.csv: frame 1"), HasSubstr("v_none")));
}

}  // namespace
}  // namespace radive
