// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace radive {

// Point-to-point factor: a point of the scan lies on its nearest neighbour in the submap.
//
//   r = (R p + t - q) / sigma
//
// T_submap_radar = (R, t)  pose of the radar in the submap: maps p to the submap frame
// p                        point of the scan, radar frame                       [m]
// q                        its nearest neighbour, submap frame                  [m]
// sigma                    standard deviation of their distance along an axis   [m]
//
// Parameter blocks: T_submap_radar [qx qy qz qw tx ty tz] (7). Residuals: 3, unit-free.
// Source: Besl and McKay 1992.
class PointToPointFactor {
 public:
  PointToPointFactor(const Eigen::Vector3d& p_radar, const Eigen::Vector3d& q_submap, double sigma)
      : p_radar_(p_radar), q_submap_(q_submap), inv_sigma_(1.0 / sigma) {}

  template <typename T>
  bool operator()(const T* const pose, T* residuals) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q_submap_radar(pose);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t_submap_radar(pose + 4);
    Eigen::Map<Eigen::Matrix<T, 3, 1>> r(residuals);
    r = inv_sigma_ * (q_submap_radar * p_radar_.cast<T>() + t_submap_radar - q_submap_.cast<T>());
    return true;
  }

  static ceres::CostFunction* Create(const Eigen::Vector3d& p_radar,
                                     const Eigen::Vector3d& q_submap,
                                     double sigma) {
    return new ceres::AutoDiffCostFunction<PointToPointFactor, 3 /* residuals */, 7 /* pose */>(
        new PointToPointFactor(p_radar, q_submap, sigma));
  }

 private:
  const Eigen::Vector3d p_radar_;
  const Eigen::Vector3d q_submap_;
  const double inv_sigma_;
};

}  // namespace radive
