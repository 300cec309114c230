// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/geometry/rotation_between.h"

#include <gtest/gtest.h>

namespace radive {
namespace {

TEST(RotationBetween, QuarterTurn) {
  const Eigen::Quaterniond q =
      RotationBetween(2.0 * Eigen::Vector3d::UnitX(), 3.0 * Eigen::Vector3d::UnitY());
  EXPECT_NEAR(q.w(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(q.z(), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR((q * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-15);
}

TEST(RotationBetween, OppositeDirectionsTakeHalfATurn) {
  const Eigen::Vector3d v = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
  const Eigen::Quaterniond q = RotationBetween(v, -v);
  EXPECT_NEAR(q.norm(), 1.0, 1e-15);
  EXPECT_NEAR((q * v + v).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace radive
