// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/geometry/pose_covariance.h"

#include <gtest/gtest.h>

namespace radive {
namespace {

// Yaw that is uncertain by 0.1 rad moves a point 2 m ahead sideways by 0.2 m, to the left for a
// turn to the left.
TEST(PoseCovariance, YawMovesAPointAhead) {
  Matrix6d covariance = Matrix6d::Zero();
  covariance(2, 2) = 0.01;
  const Matrix6d moved = CovarianceAtLever(covariance, {2.0, 0.0, 0.0});
  Matrix6d expected = covariance;
  expected(4, 4) = 0.04;
  expected(2, 4) = expected(4, 2) = 0.02;
  EXPECT_LT((moved - expected).norm(), 1e-15);
}

// A quarter turn to the left: what was along x is along y.
TEST(PoseCovariance, TurnsWithTheAxes) {
  Matrix6d covariance = Matrix6d::Zero();
  covariance.diagonal() << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
  covariance(0, 3) = covariance(3, 0) = 0.5;
  Eigen::Matrix3d R;
  R << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  Matrix6d expected = Matrix6d::Zero();
  expected.diagonal() << 2.0, 1.0, 3.0, 5.0, 4.0, 6.0;
  expected(1, 4) = expected(4, 1) = 0.5;
  EXPECT_LT((TurnedCovariance(R, covariance) - expected).norm(), 1e-15);
}

}  // namespace
}  // namespace radive
