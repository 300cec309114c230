// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/output_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace radive {
namespace {

constexpr double kQuarterTurn = 1.5707963267948966;

// A radar 3 m ahead of the rear axle that looks to the left.
RunConfig Config(OutputOptions::Frame frame) {
  RunConfig config;
  config.odometry.sensor.mount_x = 3.0;
  config.odometry.sensor.mount_yaw = kQuarterTurn;
  config.output.frame = frame;
  return config;
}

// The radar has moved by (1, 2, 0) and turned to its left by a quarter.
OdometryResult Result() {
  OdometryResult result;
  result.T_world_body = {QuaternionFromRotationVector({0, 0, kQuarterTurn}), {1, 2, 0}};
  result.T_world_radar = result.T_world_body;
  result.covariance(2, 2) = 0.01;
  result.keyframe_points = {{5, 0, 1}};
  return result;
}

void ExpectPose(const Rigid3& T, const Eigen::Vector3d& translation, double yaw) {
  EXPECT_NEAR((T.translation - translation).norm(), 0.0, 1e-12) << T.translation.transpose();
  EXPECT_NEAR(RotationVector(T.rotation).z(), yaw, 1e-12);
}

TEST(OutputFrame, OfTheBodyChangesNothing) {
  for (const auto frame : {OutputOptions::Frame::kBody, OutputOptions::Frame::kRadar}) {
    OdometryResult result = Result();
    OutputFrame(Config(frame), 0).Apply(&result);
    EXPECT_EQ(result.T_world_body.translation, Result().T_world_body.translation);
    EXPECT_EQ(result.T_world_body.rotation.coeffs(), Result().T_world_body.rotation.coeffs());
    EXPECT_EQ(result.covariance, Result().covariance);
    EXPECT_EQ(result.keyframe_points[0], Eigen::Vector3d(5, 0, 1));
  }
}

// The radar's first x axis is the vehicle's y. The rear axle lay at (0, 3) of the radar's frame,
// whose left is the vehicle's backward; after the quarter turn it lies at (1 - 3, 2) there, so it
// has moved by (-2, -1): in the vehicle's axes, x = -left, y = forward of the radar, (1, -2).
TEST(OutputFrame, OfTheVehicleMovesAndTurnsWithTheRadar) {
  OdometryResult result = Result();
  OutputFrame(Config(OutputOptions::Frame::kVehicle), 0).Apply(&result);
  ExpectPose(result.T_world_body, {1, -2, 0}, kQuarterTurn);
  // A point 5 m ahead of the first radar lies to the left of the vehicle.
  EXPECT_NEAR((result.keyframe_points[0] - Eigen::Vector3d(3, 5, 1)).norm(), 0.0, 1e-12);
  // The axle is 3 m from the radar, on the right of the turned vehicle's radar: the yaw's 0.1 rad
  // move it by 0.3 m, across that lever. It points along the world's -y (vehicle axes), so along x.
  EXPECT_NEAR(result.covariance(3, 3), 0.09, 1e-12);
  EXPECT_NEAR(result.covariance(4, 4), 0.0, 1e-12);
  EXPECT_NEAR(result.covariance(2, 2), 0.01, 1e-12);
  EXPECT_NEAR((result.T_world_radar.translation - Eigen::Vector3d(1, 1, 0)).norm(), 0.0, 1e-12);
}

// The truth is of a lidar 1 m above the radar, which looks where the vehicle does.
TEST(OutputFrame, OfTheReferenceIsWhereItsMountSays) {
  RunConfig config = Config(OutputOptions::Frame::kReference);
  config.reference.mount = {0, 0, 1, 0, 0, -kQuarterTurn};
  OdometryResult result = Result();
  OutputFrame(config, 0).Apply(&result);
  // Its first axes are the vehicle's: the radar's (1, 2) are (-2, 1) in them.
  ExpectPose(result.T_world_body, {-2, 1, 0}, kQuarterTurn);

  // Seen from the trajectory that is written.
  config.output.frame = OutputOptions::Frame::kBody;
  ExpectPose(OutputFrame(config, 0).T_output_reference(), {0, 0, 1}, -kQuarterTurn);
  config.output.frame = OutputOptions::Frame::kVehicle;
  ExpectPose(OutputFrame(config, 0).T_output_reference(), {3, 0, 1}, 0.0);
  config.reference.mounted_on = ReferenceOptions::MountedOn::kVehicle;
  ExpectPose(OutputFrame(config, 0).T_output_reference(), {0, 0, 1}, -kQuarterTurn);
  config.output.frame = OutputOptions::Frame::kReference;
  ExpectPose(OutputFrame(config, 0).T_output_reference(), {0, 0, 0}, 0.0);
}

TEST(OutputFrame, TakesTheMountOfTheFirstRadar) {
  RunConfig config;
  config.odometry.motion.body = MotionOptions::Body::kVehicle;
  config.odometry.sensor.mounts = {1, 2, 0, 0, 0, 0, 0, 7, 3, 0, 0, 0, 0, 0};
  config.output.frame = OutputOptions::Frame::kRadar;
  OdometryResult result;
  result.T_world_body = {QuaternionFromRotationVector({0, 0, kQuarterTurn}), {0, 0, 0}};
  OutputFrame(config, 7).Apply(&result);
  ExpectPose(result.T_world_body, {-3, 3, 0}, kQuarterTurn);
}

}  // namespace
}  // namespace radive
