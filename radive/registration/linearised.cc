// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/registration/linearised.h"

#include <glog/logging.h>

#include <Eigen/Geometry>

namespace radive {

Linearised Linearise(const ceres::CostFunction& factor, const double* pose) {
  const int rows = factor.num_residuals();
  CHECK_LE(rows, 6);
  Linearised result;
  result.residuals.resize(rows);
  Eigen::Matrix<double, Eigen::Dynamic, 7, Eigen::RowMajor, 6, 7> jacobian(rows, 7);
  const double* blocks[] = {pose};
  double* jacobians[] = {jacobian.data()};
  factor.Evaluate(blocks, result.residuals.data(), jacobians);
  // A rotation vector dr changes the quaternion by (dr / 2) q.
  Eigen::Matrix<double, 7, 6> ambient = Eigen::Matrix<double, 7, 6>::Zero();
  const Eigen::Quaterniond q(pose[3], pose[0], pose[1], pose[2]);
  for (int i = 0; i < 3; ++i) {
    Eigen::Quaterniond half(0.0, 0.0, 0.0, 0.0);
    half.coeffs()[i] = 0.5;
    ambient.block<4, 1>(0, i) = (half * q).coeffs();
    ambient(4 + i, 3 + i) = 1.0;
  }
  result.jacobian = jacobian * ambient;
  return result;
}

}  // namespace radive
