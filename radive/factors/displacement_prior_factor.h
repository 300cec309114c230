// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "radive/geometry/rigid3.h"

namespace radive {

// Displacement prior factor: between two scans the radar moves by its mean ego velocity.
//
//   T_0_1 = T_submap_radar0^-1 T_submap_radar1 = (q, t),   h = q^(1/2)
//   r     = W (h^-1 t - d)
//
// 0, 1  the previous scan (held fixed) and this one
// d     displacement by the ego velocity: mean of both scans' v_radar, times the time     [m]
// W     square-root information of d, W^T W = covariance^-1, radar frame half-way         [1/m]
//
// h^-1 t is the chord of the motion in the radar frame half-way, the frame in which the mean of the
// velocities at both ends lives. The direction of the ego velocity thereby informs the rotation.
// Parameter blocks: T_submap_radar1 [qx qy qz qw tx ty tz] (7). Residuals: 3, unit-free.
// Source: RaDiVe, "Ego-Velocity Translation Prior", made always-on and weighted.
class DisplacementPriorFactor {
 public:
  DisplacementPriorFactor(const Rigid3& T_submap_radar0,
                          const Eigen::Vector3d& displacement,
                          const Eigen::Matrix3d& sqrt_information)
      : T_submap_radar0_(T_submap_radar0),
        displacement_(displacement),
        sqrt_information_(sqrt_information) {}

  template <typename T>
  bool operator()(const T* const pose, T* residuals) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q_submap_radar1(pose);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t_submap_radar1(pose + 4);
    const Eigen::Quaternion<T> q_radar0_submap = T_submap_radar0_.rotation.conjugate().cast<T>();
    const Eigen::Matrix<T, 3, 1> t =
        q_radar0_submap * (t_submap_radar1 - T_submap_radar0_.translation.cast<T>());
    Eigen::Quaternion<T> half = q_radar0_submap * q_submap_radar1;
    // The root of a unit quaternion lies half-way to the identity; q and -q are one rotation.
    if (half.w() < T(0.0)) half.coeffs() = -half.coeffs();
    half.w() += T(1.0);
    half.normalize();
    Eigen::Map<Eigen::Matrix<T, 3, 1>> r(residuals);
    r = sqrt_information_.cast<T>() * (half.conjugate() * t - displacement_.cast<T>());
    return true;
  }

  static ceres::CostFunction* Create(const Rigid3& T_submap_radar0,
                                     const Eigen::Vector3d& displacement,
                                     const Eigen::Matrix3d& sqrt_information) {
    return new ceres::
        AutoDiffCostFunction<DisplacementPriorFactor, 3 /* residuals */, 7 /* pose */>(
            new DisplacementPriorFactor(T_submap_radar0, displacement, sqrt_information));
  }

 private:
  const Rigid3 T_submap_radar0_;
  const Eigen::Vector3d displacement_;
  const Eigen::Matrix3d sqrt_information_;
};

}  // namespace radive
