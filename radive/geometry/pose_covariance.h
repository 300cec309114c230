// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "radive/geometry/rigid3.h"

namespace radive {

// Covariances of poses have the order [rotation (3), translation (3)], both in the axes of one
// frame: the true pose is (exp(dr) R, t + dt) [rad^2, rad m, m^2].
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// The same covariance in axes that are turned by R: of R dr and R dt.
inline Matrix6d TurnedCovariance(const Eigen::Matrix3d& R, const Matrix6d& covariance) {
  Matrix6d jacobian = Matrix6d::Zero();
  jacobian.topLeftCorner<3, 3>() = R;
  jacobian.bottomRightCorner<3, 3>() = R;
  return jacobian * covariance * jacobian.transpose();
}

// Of a point that is rigidly joined to the one whose covariance is given, at `lever` from it [m]:
// its translation moves by dt + dr x lever.
inline Matrix6d CovarianceAtLever(const Matrix6d& covariance, const Eigen::Vector3d& lever) {
  Matrix6d jacobian = Matrix6d::Identity();
  jacobian.bottomLeftCorner<3, 3>() = -Skew(lever);
  return jacobian * covariance * jacobian.transpose();
}

}  // namespace radive
