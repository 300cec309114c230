// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/find_pose_columns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace radive {
namespace {

using ::testing::HasSubstr;

struct Read {
  PoseColumns columns;
  RecordedTrajectory poses;
};

Read Parse(const std::string& text) {
  Read read;
  std::string error;
  const std::optional<PoseColumns> columns = FindPoseColumns(text, "table", &error);
  EXPECT_TRUE(columns) << text << error;
  if (!columns) return read;
  read.columns = *columns;
  EXPECT_TRUE(ParsePoseTable(text, *columns, "table", &read.poses, &error)) << text << error;
  return read;
}

std::string ErrorOfColumns(const std::string& text) {
  std::string error;
  EXPECT_FALSE(FindPoseColumns(text, "table", &error)) << text;
  return error;
}

// At (1, 2, 3), turned by 90 degrees to the left: x points along the world's y.
void ExpectTurnedLeft(const RecordedPose& pose, const std::string& what) {
  EXPECT_NEAR((pose.T_world_body.translation - Eigen::Vector3d(1, 2, 3)).norm(), 0.0, 1e-12)
      << what;
  EXPECT_NEAR((pose.T_world_body.rotation.col(0) - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-6)
      << what;
  EXPECT_NEAR((pose.T_world_body.rotation.col(2) - Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-6)
      << what;
}

// The same two poses in rows of [R | t], of the 4x4 matrix, and in its columns.
constexpr char kTurned12[] = "0 -1 0 1 1 0 0 2 0 0 1 3";
constexpr char kTurned16[] = "0 -1 0 1 1 0 0 2 0 0 1 3 0 0 0 1";
constexpr char kTurned16Columns[] = "0 1 0 0 -1 0 0 0 0 0 1 0 1 2 3 1";
constexpr char kStart12[] = "1 0 0 0 0 1 0 0 0 0 1 0";
constexpr char kStart16[] = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";

TEST(FindPoseColumns, MatricesWithAndWithoutColumnsInFront) {
  for (const auto& [start, turned] : {std::pair(kStart12, kTurned12),
                                      std::pair(kStart16, kTurned16),
                                      std::pair(kStart16, kTurned16Columns)}) {
    const std::string a(start), b(turned);
    for (const auto& [first, second, stamp_ns] :
         {std::tuple("", "", std::int64_t{-1}),
          std::tuple("0 ", "1 ", std::int64_t{-1}),
          std::tuple("1 ", "2 ", std::int64_t{-1}),
          std::tuple("10.5 ", "10.625 ", std::int64_t{10625000000}),
          std::tuple(
              "1700000000100000000 ", "1700000000200000000 ", std::int64_t{1700000000200000000}),
          std::tuple("0 10.5 ", "1 10.625 ", std::int64_t{10625000000})}) {
      const std::string text = first + a + "\n" + second + b + "\n";
      const Read read = Parse(text);
      ASSERT_EQ(read.poses.size(), 2u);
      ExpectTurnedLeft(read.poses[1], text);
      EXPECT_EQ(read.columns.stamp >= 0, stamp_ns >= 0) << text;
      EXPECT_EQ(read.poses[1].stamp_ns, std::max<std::int64_t>(0, stamp_ns)) << text;
    }
  }
}

TEST(FindPoseColumns, NamesDecideWhereThereAreEightColumnsToo) {
  const std::string half = "0.7071067811865476";
  const std::vector<std::string> texts = {
      "timestamp,tx,ty,tz,qw,qx,qy,qz\n5,1,2,3," + half + ",0,0," + half + "\n",
      "# t qw qx qy qz x y z\n5 " + half + " 0 0 " + half + " 1 2 3\n",
      "#seq time [s] x [m] y [m] z [m] qx qy qz qw\n0 5 1 2 3 0 0 " + half + " " + half + "\n",
      "%time,field.header.seq,pose.position.x,pose.position.y,pose.position.z,orientation.x,"
      "orientation.y,orientation.z,orientation.w\n5,0,1,2,3,0,0," +
          half + "," + half + "\n",
      "secs,nsecs,x,y,z,roll,pitch,yaw [deg]\n5,0,1,2,3,0,0,90\n",
      "time_ms,x,y,z,yaw_deg,pitch_deg,roll_deg\n5000,1,2,3,90,0,0\n",
      "t,x,y,z,roll,pitch,yaw\n5,1,2,3,0,0,1.5707963267948966\n",
      "t;x;y;z;roll;pitch;yaw\n5,0;1,0;2,0;3,0;0;0;1,5707963267948966\n",
      "stamp,r11,r12,r13,r21,r22,r23,r31,r32,r33,tx,ty,tz\n5,0,-1,0,1,0,0,0,0,1,1,2,3\n",
      "\xEF\xBB\xBFtime;x;y;z;qx;qy;qz;qw\r\n5;1;2;3;0;0;0,7071067811865476;0,"
      "7071067811865476\r\n"};
  for (const std::string& text : texts) {
    const Read read = Parse(text);
    ASSERT_EQ(read.poses.size(), 1u) << text;
    ExpectTurnedLeft(read.poses[0], text);
    EXPECT_EQ(read.poses[0].stamp_ns, 5000000000) << text;
  }
  EXPECT_EQ(Parse("secs,nsecs,x,y,z,qx,qy,qz,qw\n1700000000,5,1,2,3,0,0,0,1\n").poses[0].stamp_ns,
            1700000000000000005);
}

TEST(FindPoseColumns, QuaternionsByTheirLength) {
  // An index, then t x y z: the index counts, and the stamps ascend.
  const Read indexed = Parse("0 5.5 1 2 9 0.6 0 0 0.8\n1 5.6 1 2 9 0.6 0 0 0.8\n");
  EXPECT_EQ(indexed.poses[1].stamp_ns, 5600000000);
  EXPECT_EQ(indexed.poses[1].T_world_body.translation, Eigen::Vector3d(1, 2, 9));
  const Read seven = Parse("1 2 3 0 0 0.6 0.8\n");
  EXPECT_EQ(seven.columns.stamp, -1);
  EXPECT_NEAR(seven.poses[0].T_world_body.rotation(0, 0), 0.28, 1e-12);  // 1 - 2 * 0.36
  // Decimal commas between blanks.
  const Read commas = Parse("5,5 1,5 2 3 0 0 0,6 0,8\n");
  EXPECT_EQ(commas.poses[0].stamp_ns, 5500000000);
  EXPECT_EQ(commas.poses[0].T_world_body.translation.x(), 1.5);
}

TEST(FindPoseColumns, SaysWhatToSetWhereNothingTells) {
  EXPECT_THAT(ErrorOfColumns("1 2 3 4 5 6 7 8 9 10 11 12 13\n"), HasSubstr("table:1: 13 columns"));
  EXPECT_THAT(ErrorOfColumns("1 2 3 4 5 6 7 8 9 10 11 12 13\n"), HasSubstr("reference.format"));
  EXPECT_THAT(ErrorOfColumns("1,2,3\n"), HasSubstr("3 columns"));
  EXPECT_THAT(ErrorOfColumns("1 2 3 0 0 0 1\n1 2\n"), HasSubstr("different numbers of columns"));
  EXPECT_THAT(ErrorOfColumns("a,b,c,d,e,f,g,h\n1,2,3,4,0,0,0,1\n"),
              HasSubstr("found 'a,b,c,d,e,f,g,h'"));
  EXPECT_THAT(ErrorOfColumns("5,0,1,0,2,0,3,0,0,0,0,0,0,0,1,0\n"), HasSubstr("decimal commas?"));
  EXPECT_THAT(ErrorOfColumns("# nothing\n"), HasSubstr("holds no poses"));
}

TEST(FindPoseColumns, StampsThatCannotBeAreNamedAsStamps) {
  std::string error;
  RecordedTrajectory poses;
  const std::string text = "1.4e300 1 2 3 0 0 0 1\n";
  const auto columns = FindPoseColumns(text, "table", &error);
  ASSERT_TRUE(columns);
  EXPECT_FALSE(ParsePoseTable(text, *columns, "table", &poses, &error));
  EXPECT_THAT(error, HasSubstr("expected a stamp"));
  // As numpy.savetxt writes nanoseconds.
  EXPECT_EQ(Parse("1.400000000500000000e+18 1 2 3 0 0 0 1\n").poses[0].stamp_ns,
            1400000000500000000);
}

}  // namespace
}  // namespace radive
