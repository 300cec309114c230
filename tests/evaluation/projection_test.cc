// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/projection.h"

#include <gtest/gtest.h>

#include "radive/util/angle_units.h"
#include "tests/evaluation/evaluation_test_utils.h"

namespace radive {
namespace {

using testing::Rotation;

constexpr double kRoll = 0.3;
constexpr double kPitch = -0.4;
constexpr double kYaw = 2.5;

MatrixPose Projected(Plane plane, double roll, double pitch, double yaw) {
  const Eigen::Matrix3d R = Rotation(Eigen::Vector3d::UnitZ(), yaw) *
                            Rotation(Eigen::Vector3d::UnitY(), pitch) *
                            Rotation(Eigen::Vector3d::UnitX(), roll);
  std::vector<MatrixPose> poses = {MatrixPose(R, Eigen::Vector3d(1, 2, 3))};
  ProjectToPlane(plane, &poses);
  return poses[0];
}

TEST(Projection, XyKeepsTheYaw) {
  const MatrixPose pose = Projected(Plane::kXy, kRoll, kPitch, kYaw);
  EXPECT_EQ(pose.translation, Eigen::Vector3d(1, 2, 0));
  EXPECT_LT((pose.rotation - Rotation(Eigen::Vector3d::UnitZ(), kYaw)).norm(), 1e-14);
}

TEST(Projection, XzKeepsThePitch) {
  const MatrixPose pose = Projected(Plane::kXz, kRoll, kPitch, kYaw);
  EXPECT_EQ(pose.translation, Eigen::Vector3d(1, 0, 3));
  EXPECT_LT((pose.rotation - Rotation(Eigen::Vector3d::UnitY(), kPitch)).norm(), 1e-14);
}

TEST(Projection, YzKeepsTheRoll) {
  const MatrixPose pose = Projected(Plane::kYz, kRoll, kPitch, kYaw);
  EXPECT_EQ(pose.translation, Eigen::Vector3d(0, 2, 3));
  EXPECT_LT((pose.rotation - Rotation(Eigen::Vector3d::UnitX(), kRoll)).norm(), 1e-14);
}

TEST(Projection, GimbalLockHasNoYaw) {
  // Exactly 90 degrees of pitch: yaw and roll turn about the same axis, and roll takes it all.
  Eigen::Matrix3d R;
  R << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  R = R * Rotation(Eigen::Vector3d::UnitX(), kRoll);
  std::vector<MatrixPose> poses = {MatrixPose(R, Eigen::Vector3d::Zero())};
  std::vector<MatrixPose> copy = poses;
  ProjectToPlane(Plane::kXy, &poses);
  EXPECT_LT((poses[0].rotation - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  ProjectToPlane(Plane::kYz, &copy);
  EXPECT_LT((copy[0].rotation - Rotation(Eigen::Vector3d::UnitX(), kRoll)).norm(), 1e-14);
}

TEST(Projection, NoneChangesNothing) {
  EXPECT_EQ(Projected(Plane::kNone, 0.1, 0.2, 0.3).translation, Eigen::Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace radive
