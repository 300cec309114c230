// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/geometry/pose_covariance.h"

#include <gtest/gtest.h>

namespace radive {
namespace {

// Two metres ahead of a body whose yaw is uncertain by 0.1 rad: 0.2 m sideways.
TEST(PoseCovariance, YawMovesWhatIsAheadSideways) {
  Matrix6d covariance = Matrix6d::Zero();
  covariance(2, 2) = 0.01;
  covariance(3, 3) = 0.5;
  const Matrix6d ahead = CovarianceAtLever(covariance, {2, 0, 0});
  EXPECT_NEAR(ahead(4, 4), 0.04, 1e-15);
  EXPECT_NEAR(ahead(2, 4), 0.02, 1e-15);
  EXPECT_NEAR(ahead(3, 3), 0.5, 1e-15);
  EXPECT_NEAR(ahead(2, 2), 0.01, 1e-15);
}

TEST(PoseCovariance, TurnsWithTheWorld) {
  Matrix6d covariance = Matrix6d::Zero();
  covariance(0, 0) = 1.0;
  covariance(3, 3) = 2.0;
  Eigen::Matrix3d quarter_turn;
  quarter_turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const Matrix6d turned = RotatedCovariance(covariance, quarter_turn);
  EXPECT_NEAR(turned(1, 1), 1.0, 1e-15);
  EXPECT_NEAR(turned(4, 4), 2.0, 1e-15);
  EXPECT_NEAR(turned(3, 3), 0.0, 1e-15);
}

}  // namespace
}  // namespace radive
