// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/pose_relation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radive/util/angle_units.h"
#include "tests/evaluation/evaluation_test_utils.h"

namespace radive {
namespace {

using testing::Rotation;

TEST(RotationAngle, IsAccurateFromZeroToPi) {
  // Axes near each coordinate axis visit all branches.
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0.2, -0.1),
                                      Eigen::Vector3d(-0.2, 1, 0.3),
                                      Eigen::Vector3d(0.1, -0.2, -1)}) {
    for (const double angle : {0.0, 1e-9, 1e-4, 0.5, 2.0, 3.0, kPi - 1e-9, kPi}) {
      EXPECT_NEAR(RotationAngle(Rotation(axis, angle)), angle, 1e-14) << axis.transpose();
    }
  }
}

TEST(RotationAngle, IsTheShortWayRound) {
  EXPECT_NEAR(RotationAngle(Rotation(Eigen::Vector3d::UnitZ(), 2 * kPi - 0.25)), 0.25, 1e-14);
}

TEST(IsRotation, AllowsTheRoundingOfSevenDigits) {
  EXPECT_TRUE(IsRotation(Rotation({1, 1, 0}, 1.0)));
  EXPECT_TRUE(IsRotation((1.0 + 1e-7) * Rotation({1, 1, 0}, 1.0)));
  EXPECT_FALSE(IsRotation((1.0 + 1e-5) * Rotation({1, 1, 0}, 1.0)));
  EXPECT_FALSE(IsRotation(-Eigen::Matrix3d::Identity()));
}

TEST(MeasureError, EachRelationByHand) {
  // 60 degrees about z and 3-4-12 metres. |R - I|_F = sqrt(4 (1 - cos)) = sqrt(2).
  const MatrixPose E(Rotation(Eigen::Vector3d::UnitZ(), kPi / 3), Eigen::Vector3d(3, 4, 12));
  EXPECT_NEAR(*MeasureError(E, PoseRelation::kTransPart), 13.0, 1e-14);
  EXPECT_NEAR(*MeasureError(E, PoseRelation::kAngleDeg), 60.0, 1e-12);
  EXPECT_NEAR(*MeasureError(E, PoseRelation::kAngleRad), kPi / 3, 1e-14);
  EXPECT_NEAR(*MeasureError(E, PoseRelation::kRotPart), std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(*MeasureError(E, PoseRelation::kFull), std::sqrt(171.0), 1e-13);
}

TEST(MeasureError, NoAngleOfWhatIsNoRotation) {
  const MatrixPose E(2.0 * Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  EXPECT_FALSE(MeasureError(E, PoseRelation::kAngleDeg));
  EXPECT_NEAR(*MeasureError(E, PoseRelation::kRotPart), std::sqrt(3.0), 1e-14);
}

}  // namespace
}  // namespace radive
