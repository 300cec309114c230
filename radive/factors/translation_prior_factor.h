// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>

namespace radive {

// Translation prior factor: the radar's position is where the ego velocity says.
//
//   r = W (t - t_init)
//
// t       position of the radar in the submap frame                              [m]
// t_init  initial translation: last position plus ego velocity times time        [m]
// W       square-root information, W^T W = covariance^-1 of t_init               [1/m]
//
// The paper's low-speed prior lambda/2 |t - t_init|^2 is W = sqrt(lambda) I.
// Parameter blocks: T_submap_radar [qx qy qz qw tx ty tz] (7). Residuals: 3, unit-free.
// Source: RaDiVe, "Ego-Velocity Translation Prior".
class TranslationPriorFactor {
 public:
  TranslationPriorFactor(const Eigen::Vector3d& t_init, const Eigen::Matrix3d& sqrt_information)
      : t_init_(t_init), sqrt_information_(sqrt_information) {}

  template <typename T>
  bool operator()(const T* const pose, T* residuals) const {
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t(pose + 4);
    Eigen::Map<Eigen::Matrix<T, 3, 1>> r(residuals);
    r = sqrt_information_.cast<T>() * (t - t_init_.cast<T>());
    return true;
  }

  static ceres::CostFunction* Create(const Eigen::Vector3d& t_init,
                                     const Eigen::Matrix3d& sqrt_information) {
    return new ceres::AutoDiffCostFunction<TranslationPriorFactor, 3 /* residuals */, 7 /* pose */>(
        new TranslationPriorFactor(t_init, sqrt_information));
  }

 private:
  const Eigen::Vector3d t_init_;
  const Eigen::Matrix3d sqrt_information_;
};

}  // namespace radive
