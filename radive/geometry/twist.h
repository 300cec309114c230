// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>

#include "radive/geometry/rigid3.h"

namespace radive {

// [rotation vector (3), translation (3)] of a motion at constant velocity in the moving frame, for
// the whole of it [rad, m] or per second.
using Twist = Eigen::Matrix<double, 6, 1>;

// The motion along a twist: the exponential map of SE(3).
inline Rigid3 MotionAlong(const Twist& twist) {
  const Eigen::Vector3d w = twist.head<3>();
  const double square = w.squaredNorm(), angle = std::sqrt(square);
  // (1 - cos a) / a^2 and (a - sin a) / a^3, by their series near zero.
  const double b = angle < 1e-3 ? 0.5 - square / 24.0 : (1.0 - std::cos(angle)) / square;
  const double c =
      angle < 1e-3 ? 1.0 / 6.0 - square / 120.0 : (angle - std::sin(angle)) / (square * angle);
  const Eigen::Matrix3d W = Skew(w);
  const Eigen::Matrix3d V = Eigen::Matrix3d::Identity() + b * W + c * W * W;
  return {QuaternionFromRotationVector(w), V * twist.tail<3>()};
}

// The twist of a motion that turns by less than pi: the logarithm of SE(3).
inline Twist TwistOf(const Rigid3& motion) {
  const Eigen::Vector3d w = RotationVector(motion.rotation);
  const double square = w.squaredNorm(), angle = std::sqrt(square);
  // (1 - (a / 2) cot(a / 2)) / a^2, by its series near zero.
  const double d = angle < 1e-3 ? 1.0 / 12.0 + square / 720.0
                                : (1.0 - 0.5 * angle / std::tan(0.5 * angle)) / square;
  const Eigen::Matrix3d W = Skew(w);
  Twist twist;
  twist << w, (Eigen::Matrix3d::Identity() - 0.5 * W + d * W * W) * motion.translation;
  return twist;
}

}  // namespace radive
