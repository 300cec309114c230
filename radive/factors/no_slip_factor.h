// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "radive/geometry/rigid3.h"

namespace radive {

// No-slip factor: between two scans the point above the rear axle moves where the vehicle points.
//
//   T_e0_e1 = T_e_radar (T_submap_radar0^-1 T_submap_radar1) T_radar_e
//   psi, d  = yaw angle and translation of T_e0_e1
//   r = (cos(psi/2) d_y - sin(psi/2) d_x - b) / sigma
//
// e        frame of the vehicle at the point that does not slip: x forward, y left, z up
// 0, 1     the previous scan (held fixed) and this one
// b        lateral displacement that is known to remain: drift angle times distance [m]
// sigma    standard deviation of the lateral displacement                           [m]
//
// d turned back by half the yaw angle is the chord of the arc as seen half-way: on a circle it is
// exactly the direction of travel. A radar that sits l ahead of e sweeps sideways by l psi in a
// turn, so the factor ties yaw to the lateral motion that registration (or Doppler) observes, and
// registration's weak pairing of yaw and lateral shift is lifted.
// Parameter blocks: T_submap_radar1 [qx qy qz qw tx ty tz] (7). Residuals: 1, unit-free.
class NoSlipFactor {
 public:
  NoSlipFactor(const Rigid3& T_submap_radar0,
               const Rigid3& T_e_radar,
               double lateral_offset,
               double sigma)
      : T_submap_radar0_(T_submap_radar0),
        T_e_radar_(T_e_radar),
        lateral_offset_(lateral_offset),
        inv_sigma_(1.0 / sigma) {}

  template <typename T>
  bool operator()(const T* const pose, T* residual) const {
    using std::atan2;
    using std::cos;
    using std::sin;
    const Eigen::Map<const Eigen::Quaternion<T>> q_submap_radar1(pose);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t_submap_radar1(pose + 4);
    const Eigen::Quaternion<T> q_radar0_submap = T_submap_radar0_.rotation.conjugate().cast<T>();
    const Eigen::Quaternion<T> q_radar = q_radar0_submap * q_submap_radar1;
    const Eigen::Matrix<T, 3, 1> t_radar =
        q_radar0_submap * (t_submap_radar1 - T_submap_radar0_.translation.cast<T>());
    const Eigen::Quaternion<T> q_e_radar = T_e_radar_.rotation.cast<T>();
    const Eigen::Matrix<T, 3, 1> lever = T_e_radar_.translation.cast<T>();
    const Eigen::Quaternion<T> q_e = q_e_radar * q_radar * q_e_radar.conjugate();
    // The radar's displacement, less what the turn of the lever contributes.
    const Eigen::Matrix<T, 3, 1> d = q_e_radar * t_radar + lever - q_e * lever;
    const T half_psi = atan2(q_e.z(), q_e.w());
    residual[0] =
        T(inv_sigma_) * (cos(half_psi) * d[1] - sin(half_psi) * d[0] - T(lateral_offset_));
    return true;
  }

  static ceres::CostFunction* Create(const Rigid3& T_submap_radar0,
                                     const Rigid3& T_e_radar,
                                     double lateral_offset,
                                     double sigma) {
    return new ceres::AutoDiffCostFunction<NoSlipFactor, 1 /* residuals */, 7 /* pose */>(
        new NoSlipFactor(T_submap_radar0, T_e_radar, lateral_offset, sigma));
  }

 private:
  const Rigid3 T_submap_radar0_;
  const Rigid3 T_e_radar_;
  const double lateral_offset_;
  const double inv_sigma_;
};

}  // namespace radive
