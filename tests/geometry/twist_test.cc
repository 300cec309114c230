// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/geometry/twist.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radive/util/angle_units.h"
#include "tests/synthetic_scene.h"

namespace radive {
namespace {

// A quarter of a circle to the left with radius 2 m, climbing 1 m.
TEST(Twist, DrivesAHelix) {
  Twist twist;
  twist << 0.0, 0.0, 0.5 * kPi, kPi, 0.0, 1.0;
  const Rigid3 motion = MotionAlong(twist);
  EXPECT_LT((motion.translation - Eigen::Vector3d(2.0, 2.0, 1.0)).norm(), 1e-14);
  EXPECT_LT((motion.rotation * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-14);
}

TEST(Twist, LogarithmUndoesTheExponential) {
  Random random(1);
  for (const double angle : {0.0, 1e-9, 1e-4, 9.99e-4, 1.01e-3, 0.1, 3.0}) {
    for (int i = 0; i < 20; ++i) {
      Twist twist;
      twist << angle * testing::RandomNormal3(&random).normalized(),
          5.0 * testing::RandomNormal3(&random);
      EXPECT_LT((TwistOf(MotionAlong(twist)) - twist).norm(), 1e-11) << angle;
    }
  }
}

// Half the twist twice is the twist.
TEST(Twist, IsConstantAlongTheMotion) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Rigid3 motion = testing::RandomRigid3(2.0, 10.0, &random);
    const Rigid3 half = MotionAlong(0.5 * TwistOf(motion));
    const Rigid3 rest = (half * half).Inverse() * motion;
    EXPECT_LT(rest.translation.norm() + RotationVector(rest.rotation).norm(), 1e-11);
  }
}

}  // namespace
}  // namespace radive
