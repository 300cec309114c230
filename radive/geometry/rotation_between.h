// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

namespace radive {

// The shortest rotation that takes the direction of `from` to that of `to`; neither is zero. For
// opposite directions half a turn about some axis across them. Eigen's FromTwoVectors() finds that
// axis by an SVD, which takes seconds to compile.
inline Eigen::Quaterniond RotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  Eigen::Quaterniond q;
  if (cosine < -1.0 + Eigen::NumTraits<double>::dummy_precision()) {
    q.w() = 0.0;
    q.vec() = a.unitOrthogonal();
    return q;
  }
  const double root = std::sqrt((1.0 + cosine) * 2.0);  // twice the cosine of half the angle
  q.vec() = a.cross(b) * (1.0 / root);
  q.w() = root * 0.5;
  return q;
}

}  // namespace radive
