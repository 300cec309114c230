// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/cost_function.h>

#include <Eigen/Core>

namespace radive {

// Residuals, at most six, of a factor on one pose, and its Jacobian in the tangent space
// [rotation vector, translation] of a pose that is perturbed from the left.
struct Linearised {
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1> residuals;
  Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::ColMajor, 6, 6> jacobian;
};

// `pose` is a pose block [qx qy qz qw tx ty tz].
Linearised Linearise(const ceres::CostFunction& factor, const double* pose);

}  // namespace radive
