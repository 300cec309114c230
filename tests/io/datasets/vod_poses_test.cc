// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/vod_poses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/scan_files.h"
#include "tests/shared_data.h"

namespace radive {
namespace {

using ::testing::HasSubstr;

// The camera looks along the world's y; its x is the world's x, its y points down.
constexpr char kPose[] =
    "{\"odomToCamera\": [1,0,0,10, 0,0,1,20, 0,-1,0,30, 0,0,0,1]}\n"
    "{\"mapToCamera\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}";
// The radar, forward left up, sits 2 m above the camera.
constexpr char kCalibration[] =
    "P0: 1 2 3\nTr_velo_to_cam: 0 -1 0 0 0 0 -1 -2 1 0 0 0\nTr_imu_to_velo: \n";

TEST(VodPoses, ParsesThePoseCalledOdomToCamera) {
  MatrixPose pose;
  std::string error;
  ASSERT_TRUE(ParseVodPose(kPose, &pose, &error)) << error;
  EXPECT_EQ(pose.translation, Eigen::Vector3d(10, 20, 30));
  EXPECT_NEAR((pose.rotation.col(2) - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-15);
  for (const char* bad : {"",
                          "[1]",
                          "{\"mapToCamera\": [1]}",
                          "{\"odomToCamera\": [1,2,3]}",
                          "{\"odomToCamera\": [2,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}"}) {
    EXPECT_FALSE(ParseVodPose(bad, &pose, &error)) << bad;
    EXPECT_THAT(error, HasSubstr("odomToCamera: 16 numbers"));
  }
}

TEST(VodPoses, GivesThePoseOfTheRadar) {
  const testing::TempFolder folder;
  for (const char* name : {"00010", "00009"}) {
    folder.Write(std::string("radar/training/pose/") + name + ".json", kPose);
    folder.Write(std::string("radar/training/calib/") + name + ".txt", kCalibration);
  }
  const auto poses = FindVodPoses(folder.path());
  ASSERT_TRUE(poses);
  std::string error;
  const auto trajectory = ReadVodPoses(*poses, &error);
  ASSERT_TRUE(trajectory) << error;
  ASSERT_EQ(trajectory->size(), 2u);
  const MatrixPose& T_odom_radar = trajectory->front().T_world_body;
  EXPECT_NEAR((T_odom_radar.translation - Eigen::Vector3d(10, 20, 32)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((T_odom_radar.rotation.col(0) - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((T_odom_radar.rotation.col(2) - Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-12);
}

TEST(VodPoses, NamesTheFileThatIsMissingOrBroken) {
  const testing::TempFolder folder;
  folder.Write("pose/00001.json", kPose);
  std::string error;
  EXPECT_FALSE(ReadVodPoses(folder.path() / "pose", &error));
  EXPECT_THAT(error, HasSubstr("calib/00001.txt: cannot be opened"));
  folder.Write("calib/00001.txt", "Tr_velo_to_cam: 1 2 3\n");
  EXPECT_FALSE(ReadVodPoses(folder.path() / "pose", &error));
  EXPECT_THAT(error, HasSubstr("calib/00001.txt: expected a line 'Tr_velo_to_cam:' with the 12"));
  EXPECT_FALSE(ReadVodPoses(folder.path() / "calib", &error));
  EXPECT_THAT(error, HasSubstr("expected pose files NNNNN.json, found none"));
  EXPECT_FALSE(FindVodPoses(folder.path() / "calib"));
}

// The published frames: the radar is about 0.6 m above the ground and looks along the street.
TEST(VodPoses, ReadsTheExampleFrames) {
  RADIVE_SKIP_WITHOUT("vod-example-frames");
  const auto folder = FindVodPoses(testing::SharedData() / "vod-example-frames");
  ASSERT_TRUE(folder);
  std::string error;
  const auto trajectory = ReadVodPoses(*folder, &error);
  ASSERT_TRUE(trajectory) << error;
  ASSERT_EQ(trajectory->size(), 3u);
  for (const RecordedPose& pose : *trajectory) {
    EXPECT_GT(pose.T_world_body.rotation(2, 2), 0.99) << "z is up";
    EXPECT_NEAR(pose.T_world_body.rotation.determinant(), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace radive
