// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace radive {

// Rotation prior factor: the radar's orientation is the predicted one.
//
//   r = W (2 vec(q q_init^-1))        (the rotation vector, to second order)
//
// q       orientation of the radar in the submap frame
// q_init  predicted orientation
// W       square-root information of the rotation vector in the submap frame   [1/rad]
//
// Parameter blocks: T_submap_radar [qx qy qz qw tx ty tz] (7). Residuals: 3, unit-free.
class RotationPriorFactor {
 public:
  RotationPriorFactor(const Eigen::Quaterniond& q_init, const Eigen::Matrix3d& sqrt_information)
      : q_init_inverse_(q_init.conjugate()), sqrt_information_(sqrt_information) {}

  template <typename T>
  bool operator()(const T* const pose, T* residuals) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q(pose);
    Eigen::Quaternion<T> difference = q * q_init_inverse_.cast<T>();
    // q and -q are the same rotation: take the one near the identity.
    const T two = difference.w() < T(0.0) ? T(-2.0) : T(2.0);
    Eigen::Map<Eigen::Matrix<T, 3, 1>> r(residuals);
    r = sqrt_information_.cast<T>() * (two * difference.vec());
    return true;
  }

  static ceres::CostFunction* Create(const Eigen::Quaterniond& q_init,
                                     const Eigen::Matrix3d& sqrt_information) {
    return new ceres::AutoDiffCostFunction<RotationPriorFactor, 3 /* residuals */, 7 /* pose */>(
        new RotationPriorFactor(q_init, sqrt_information));
  }

 private:
  const Eigen::Quaterniond q_init_inverse_;
  const Eigen::Matrix3d sqrt_information_;
};

}  // namespace radive
