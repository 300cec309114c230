// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace radive {

// Point-to-plane factor: a point of the scan lies in the plane of its neighbours in the submap.
//
//   r = n . (R p + t - q) / sigma
//
// T_submap_radar = (R, t)  pose of the radar in the submap: maps p to the submap frame
// p                        point of the scan, radar frame                        [m]
// q                        a point of the plane, submap frame                    [m]
// n                        unit normal of the plane, submap frame; either side   [-]
// sigma                    standard deviation of the distance from the plane     [m]
//
// Parameter blocks: T_submap_radar [qx qy qz qw tx ty tz] (7). Residuals: 1, unit-free.
// Source: Chen and Medioni 1991.
class PointToPlaneFactor {
 public:
  PointToPlaneFactor(const Eigen::Vector3d& p_radar,
                     const Eigen::Vector3d& q_submap,
                     const Eigen::Vector3d& normal_submap,
                     double sigma)
      : p_radar_(p_radar),
        q_submap_(q_submap),
        normal_submap_(normal_submap),
        inv_sigma_(1.0 / sigma) {}

  template <typename T>
  bool operator()(const T* const pose, T* residual) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q_submap_radar(pose);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t_submap_radar(pose + 4);
    const Eigen::Matrix<T, 3, 1> distance =
        q_submap_radar * p_radar_.cast<T>() + t_submap_radar - q_submap_.cast<T>();
    residual[0] = inv_sigma_ * normal_submap_.cast<T>().dot(distance);
    return true;
  }

  static ceres::CostFunction* Create(const Eigen::Vector3d& p_radar,
                                     const Eigen::Vector3d& q_submap,
                                     const Eigen::Vector3d& normal_submap,
                                     double sigma) {
    return new ceres::AutoDiffCostFunction<PointToPlaneFactor, 1 /* residuals */, 7 /* pose */>(
        new PointToPlaneFactor(p_radar, q_submap, normal_submap, sigma));
  }

 private:
  const Eigen::Vector3d p_radar_;
  const Eigen::Vector3d q_submap_;
  const Eigen::Vector3d normal_submap_;
  const double inv_sigma_;
};

}  // namespace radive
