// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/csv_drive.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace radive {
namespace {

constexpr char kDrive[] =
    "# a drive\n"
    "time,x,y,doppler\n"
    "0.1,1,0,0\n0.1,2,0,0\n0.1,3,0,0\n"
    "0.2,4,0,0\n0.2,5,0,0\n"
    "0.3,6,0,0\n0.3,7,0,0\n0.3,8,0,0\n"
    "# one more of the second\n"
    "0.2,9,0,0\r\n";

TEST(CsvDrive, LinesWithTheSameTimeAreAScan) {
  const std::optional<CsvDrive> drive = SplitCsvDrive(kDrive);
  ASSERT_TRUE(drive);
  EXPECT_EQ(drive->column, "time");
  EXPECT_TRUE(drive->has_times);
  EXPECT_EQ(drive->head, "# a drive\ntime,x,y,doppler\n");
  ASSERT_EQ(drive->scans.size(), 3u);
  EXPECT_EQ(drive->scans[1].key, "0.2");
  EXPECT_EQ(drive->scans[0].lines, std::vector<std::string_view>{"0.1,1,0,0\n0.1,2,0,0\n0.1,3,0,0\n"});
  EXPECT_EQ(drive->scans[1].lines,
            (std::vector<std::string_view>{"0.2,4,0,0\n0.2,5,0,0\n", "0.2,9,0,0\r\n"}));
}

TEST(CsvDrive, FramesTellBetterThanTimesOfPoints) {
  const std::optional<CsvDrive> drive = SplitCsvDrive(
      "t;frame_id;x;y\n1;7;0;0\n2;7;0;0\n3;7;0;0\n4;8;0;0\n5;8;0;0\n6;8;0;0");
  ASSERT_TRUE(drive);
  EXPECT_EQ(drive->column, "frame_id");
  EXPECT_FALSE(drive->has_times);
  ASSERT_EQ(drive->scans.size(), 2u);
  EXPECT_EQ(drive->scans[1].lines[0], "4;8;0;0\n5;8;0;0\n6;8;0;0");
}

TEST(CsvDrive, OneScanIsNoDrive) {
  for (const char* text : {"", "time,x,y\n", "x,y\n1,2\n3,4\n",
                           "time,x,y\n1,2,3\n1,4,5\n1,6,7\n",                  // one time
                           "time,x,y\n1,2,3\n2,4,5\n3,6,7\n",                  // times of points
                           "time_offset_ns,x,y\n1,2,3\n1,4,5\n1,6,7\n2,2,3\n2,4,5\n2,6,7\n"}) {
    EXPECT_FALSE(SplitCsvDrive(text)) << text;
  }
}

}  // namespace
}  // namespace radive
