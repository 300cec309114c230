// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/pose_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "radive/io/datasets/dataset.h"
#include "radive/io/trajectories/find_pose_columns.h"

namespace radive {
namespace {

using ::testing::HasSubstr;

RecordedTrajectory Parse(const std::string& text, const PoseColumns& columns) {
  RecordedTrajectory poses;
  std::string error;
  EXPECT_TRUE(ParsePoseTable(text, columns, "table", &poses, &error)) << error;
  return poses;
}

std::string ErrorOf(const std::string& text, const PoseColumns& columns) {
  RecordedTrajectory poses;
  std::string error;
  EXPECT_FALSE(ParsePoseTable(text, columns, "table", &poses, &error));
  return error;
}

// Of the ground truth of a dataset.
std::optional<PoseColumns> ColumnsOf(const std::string& name, const std::string& names = "") {
  for (const Dataset& dataset : Datasets()) {
    if (dataset.name == name) return dataset.truth.columns(names);
  }
  return std::nullopt;
}

TEST(PoseTable, ReadsTheCarOfRadarScenesByTheNamesOfTheColumns) {
  const std::string names = "scan,timestamp_rad,yaw,x,timestamp_odom,y";
  const auto columns = ColumnsOf("RadarScenes", names);
  ASSERT_TRUE(columns);
  const RecordedTrajectory poses =
      Parse(names + "\n1,0.5,1.5707963267948966,10,0.070027,20\n", *columns);
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].stamp_ns, 70027000);
  EXPECT_EQ(poses[0].T_world_body.translation, Eigen::Vector3d(10, 20, 0));
  // A quarter turn to the left: forward is the world's y.
  EXPECT_NEAR(poses[0].T_world_body.rotation(1, 0), 1.0, 1e-15);
  EXPECT_FALSE(ColumnsOf("RadarScenes", "scan,timestamp_rad,x,y"));
}

TEST(PoseTable, AnglesThatCanHardlyBeRadiansAreAnError) {
  const std::string names = "scan,timestamp_rad,yaw,x,timestamp_odom,y";
  EXPECT_THAT(ErrorOf(names + "\n1,0.5,1.5,10,0.1,20\n2,0.6,-90,10,0.2,20\n",
                      *ColumnsOf("RadarScenes", names)),
              HasSubstr("table:3: expected angles in radians, found '-90' in column 3: degrees?"));
}

// As pyboreas turns them: looking along x with a yaw of 90 degrees is looking along -y.
TEST(PoseTable, ReadsBoreasWithMicrosecondsAndPassiveAngles) {
  const RecordedTrajectory poses = Parse(
      "GPSTime,easting,northing,altitude,a,b,c,roll,pitch,heading,d,e,f\n"
      "1606417097528152,1,2,3,0,0,0,0,0,1.5707963267948966,0,0,0\n"
      "1606417097628152,1,2,3,0,0,0,1.5707963267948966,0,0,0,0,0\n",
      *ColumnsOf("Boreas"));
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].stamp_ns, 1606417097528152000);
  EXPECT_NEAR(poses[0].stamp_s, 1606417097.528152, 1e-6);
  EXPECT_EQ(poses[0].T_world_body.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR((poses[0].T_world_body.rotation.col(0) + Eigen::Vector3d::UnitY()).norm(), 0, 1e-15);
  // Rolled by 90 degrees: the sensor's z is the world's y.
  EXPECT_NEAR((poses[1].T_world_body.rotation.col(2) - Eigen::Vector3d::UnitY()).norm(), 0, 1e-15);
}

TEST(PoseTable, ReadsColoRadarWithoutStamps) {
  const RecordedTrajectory poses = Parse("1 2 3 0 0 1 0\n", *ColumnsOf("ColoRadar"));
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0].T_world_body.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(poses[0].T_world_body.rotation(0, 0), -1.0, 1e-15);  // half a turn about z
}

TEST(PoseTable, FindsColumnsByTheirNames) {
  std::string error;
  EXPECT_TRUE(
      FindPoseColumns("timestamp,vx,tx,ty,tz,qw,qx,qy,qz\n1,2,3,4,5,0,1,0,0\n", "t", &error));
  const auto columns = FindPoseColumns(
      "#time[s],vx,vy,p_x[m],p_y,p_z,q_w,q_x,q_y,q_z\n1.5,7,8,1,2,3,0,1,0,0\n", "t", &error);
  ASSERT_TRUE(columns) << error;
  const RecordedTrajectory poses = Parse("#x\n1.5,7,8,1,2,3,0,1,0,0\n", *columns);
  EXPECT_EQ(poses[0].stamp_ns, 1500000000);
  EXPECT_EQ(poses[0].T_world_body.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(poses[0].T_world_body.rotation(0, 0), 1.0);  // half a turn about x
  EXPECT_EQ(poses[0].T_world_body.rotation(1, 1), -1.0);
}

TEST(PoseTable, FindsTheQuaternionByItsLength) {
  // t, position, velocity of length 1 in one of the lines only, quaternion.
  const std::string text =
      "1.5,10,20,30,0.6,0.8,0,0,0,0.6,0.8\n"
      "2.5,11,21,31,2,0,0,0,0,0.8,-0.6\n";
  std::string error;
  const auto columns = FindPoseColumns(text, "t", &error);
  ASSERT_TRUE(columns) << error;
  EXPECT_EQ(columns->quaternion, (std::array<int, 4>{7, 8, 9, 10}));
  const RecordedTrajectory poses = Parse(text, *columns);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[1].T_world_body.translation, Eigen::Vector3d(11, 21, 31));
  // w = 0.8, z = 0.6 turns by 2 atan(0.75): cosine 0.64 - 0.36.
  EXPECT_NEAR(poses[0].T_world_body.rotation(0, 0), 0.28, 1e-15);
  EXPECT_FALSE(FindPoseColumns("1,2,3,4,5,6,7,8,9,10\n", "t", &error));
  EXPECT_THAT(error, HasSubstr("no four columns in a row"));
  EXPECT_FALSE(FindPoseColumns("time,x,y,z\n1,2,3,4\n", "t", &error));
  EXPECT_THAT(error, HasSubstr("t:1: expected a name for each of the 4 columns"));
}

TEST(PoseTable, NamesLineAndExpectation) {
  EXPECT_THAT(ErrorOf("# names\n1 2 3 0 0 1\n", *ColumnsOf("ColoRadar")),
              HasSubstr("table:2: expected at least 7 columns, found 6"));
  EXPECT_THAT(ErrorOf("1 2 nan 0 0 1 0\n", *ColumnsOf("ColoRadar")),
              HasSubstr("table:1: expected a finite number in column 3, found 'nan'"));
  EXPECT_THAT(ErrorOf("\n", *ColumnsOf("ColoRadar")), HasSubstr("holds no poses"));
}

}  // namespace
}  // namespace radive
