// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "radive/geometry/rigid3.h"

namespace radive {

// Doppler factor on a pose: the motion since the previous scan explains the range rate of a return.
//
//   h   = the rotation half-way from R_0 to R
//   v   = h^-1 (t - t_0) / dt
//   r   = (v_doppler + d . v) / sigma
//
// T_submap_radar = (R, t)   pose of the radar in the submap at this scan
// T_submap_radar0           the same at the previous scan, held fixed
// dt                        time between them                                    [s]
// v                         mean velocity of the radar, in its frame             [m/s]
// d                         unit direction to the return, radar frame            [-]
// v_doppler                 its range rate, positive when it moves away          [m/s]
// sigma                     standard deviation of v_doppler                      [m/s]
//
// As in Doppler-ICP the velocity is taken as constant from scan to scan.
// Parameter blocks: T_submap_radar [qx qy qz qw tx ty tz] (7). Residuals: 1, unit-free.
// Source: Hexsel et al. 2022 (DICP), Eq. of the Doppler velocity objective.
class DopplerMotionFactor {
 public:
  DopplerMotionFactor(const Rigid3& T_submap_radar0,
                      double dt,
                      const Eigen::Vector3d& direction_radar,
                      double v_doppler,
                      double sigma)
      : T_submap_radar0_(T_submap_radar0),
        inv_dt_(1.0 / dt),
        direction_radar_(direction_radar),
        v_doppler_(v_doppler),
        inv_sigma_(1.0 / sigma) {}

  template <typename T>
  bool operator()(const T* const pose, T* residual) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q_submap_radar(pose);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t_submap_radar(pose + 4);
    const Eigen::Quaternion<T> q_radar0_submap = T_submap_radar0_.rotation.conjugate().cast<T>();
    const Eigen::Matrix<T, 3, 1> moved =
        q_radar0_submap * (t_submap_radar - T_submap_radar0_.translation.cast<T>());
    Eigen::Quaternion<T> half = q_radar0_submap * q_submap_radar;
    // The root of a unit quaternion lies half-way to the identity; q and -q are one rotation.
    if (half.w() < T(0.0)) half.coeffs() = -half.coeffs();
    half.w() += T(1.0);
    half.normalize();
    const Eigen::Matrix<T, 3, 1> v_radar = inv_dt_ * (half.conjugate() * moved);
    residual[0] = inv_sigma_ * (v_doppler_ + direction_radar_.cast<T>().dot(v_radar));
    return true;
  }

  static ceres::CostFunction* Create(const Rigid3& T_submap_radar0,
                                     double dt,
                                     const Eigen::Vector3d& direction_radar,
                                     double v_doppler,
                                     double sigma) {
    return new ceres::AutoDiffCostFunction<DopplerMotionFactor, 1 /* residuals */, 7 /* pose */>(
        new DopplerMotionFactor(T_submap_radar0, dt, direction_radar, v_doppler, sigma));
  }

 private:
  const Rigid3 T_submap_radar0_;
  const double inv_dt_;
  const Eigen::Vector3d direction_radar_;
  const double v_doppler_;
  const double inv_sigma_;
};

}  // namespace radive
