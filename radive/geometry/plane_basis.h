// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace radive {

// Two orthonormal columns that span the plane across the unit vector `normal`; with `normal` as a
// third column they are right-handed. x and y for normal = z.
inline Eigen::Matrix<double, 3, 2> PlaneBasis(const Eigen::Vector3d& normal) {
  // Any axis will do that is far from the normal.
  const Eigen::Vector3d seed =
      std::abs(normal.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  Eigen::Matrix<double, 3, 2> basis;
  basis.col(0) = (seed - normal * normal.dot(seed)).normalized();
  basis.col(1) = normal.cross(basis.col(0));
  return basis;
}

}  // namespace radive
