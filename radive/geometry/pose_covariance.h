// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace radive {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

// Covariance of the pose of a point that is rigidly joined to the one whose covariance is given, at
// `lever` from it [m] (world frame): its translation moves by dt + dr x lever. The order is
// [rotation, translation], both in the world frame.
inline Matrix6d CovarianceAtLever(const Matrix6d& covariance, const Eigen::Vector3d& lever) {
  Matrix6d jacobian = Matrix6d::Identity();
  jacobian.block<3, 3>(3, 0) << 0.0, lever.z(), -lever.y(),  //
      -lever.z(), 0.0, lever.x(),                            //
      lever.y(), -lever.x(), 0.0;
  return jacobian * covariance * jacobian.transpose();
}

// The same covariance in other world coordinates: p_new = rotation * p_world.
inline Matrix6d RotatedCovariance(const Matrix6d& covariance, const Eigen::Matrix3d& rotation) {
  Matrix6d both = Matrix6d::Zero();
  both.topLeftCorner<3, 3>() = rotation;
  both.bottomRightCorner<3, 3>() = rotation;
  return both * covariance * both.transpose();
}

}  // namespace radive
