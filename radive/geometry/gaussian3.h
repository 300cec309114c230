// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace radive {

// A weighted normal distribution in space: a voxel of an NDT map, or a single radar return with
// its measurement noise.
struct Gaussian3 {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();            // [m]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  // [m^2], positive definite
  double weight = 1.0;                                       // mean point weight [-], in (0, 1]

  // How far a submap trusts it: scales the cost of its pairs [-], in [0, 1].
  double confidence = 1.0;

  int count = 1;  // points it stands for
};

}  // namespace radive
