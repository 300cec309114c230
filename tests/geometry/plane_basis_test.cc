// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/geometry/plane_basis.h"

#include <gtest/gtest.h>

namespace radive {
namespace {

TEST(PlaneBasisTest, IsXAndYForAVerticalNormal) {
  Eigen::Matrix<double, 3, 2> expected;
  expected << 1, 0, 0, 1, 0, 0;
  EXPECT_LT((PlaneBasis(Eigen::Vector3d::UnitZ()) - expected).norm(), 1e-15);
}

TEST(PlaneBasisTest, CompletesAnyNormalToARightHandedFrame) {
  for (const Eigen::Vector3d& direction : {Eigen::Vector3d(1, 0, 0),
                                           Eigen::Vector3d(-1, 0.01, 0),
                                           Eigen::Vector3d(0, 1, 0),
                                           Eigen::Vector3d(0, 0, -1),
                                           Eigen::Vector3d(0.3, -0.5, 0.8)}) {
    Eigen::Matrix3d frame;
    frame << PlaneBasis(direction.normalized()), direction.normalized();
    EXPECT_LT((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(frame.determinant(), 1.0, 1e-14);
  }
}

}  // namespace
}  // namespace radive
