// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "radive/geometry/plane_basis.h"

namespace radive {

// Attitude and height prior factor: a road vehicle keeps its up axis and its height.
//
//   u = R a                                     the vehicle's up axis now, submap frame
//   r = [ (B^T u) / sigma_angle ; n^T (t - t_0) / sigma_height ]
//
// a             up axis of the vehicle in the radar frame (unit)
// n             reference up axis in the submap frame (unit); B its two orthonormal complements
// t, t_0        position of the radar now, and a point at the reference height   [m]
// sigma_angle   standard deviation of roll and pitch                             [rad]
// sigma_height  standard deviation of the height                                 [m]
//
// B^T u is the sine of the tilt. Elevation noise and a field of view cut by the ground bias pitch
// and height; nothing else in the cost holds them.
// Parameter blocks: T_submap_radar [qx qy qz qw tx ty tz] (7). Residuals: 3, unit-free.
class AttitudeHeightPriorFactor {
 public:
  AttitudeHeightPriorFactor(const Eigen::Vector3d& up_radar,
                            const Eigen::Vector3d& up_submap,
                            const Eigen::Vector3d& t_reference,
                            double sigma_angle,
                            double sigma_height)
      : up_radar_(up_radar.normalized()), t_reference_(t_reference) {
    const Eigen::Vector3d n = up_submap.normalized();
    axes_.topRows<2>() = PlaneBasis(n).transpose() / sigma_angle;
    axes_.row(2) = n.transpose() / sigma_height;
  }

  template <typename T>
  bool operator()(const T* const pose, T* residuals) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q(pose);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t(pose + 4);
    const Eigen::Matrix<T, 3, 1> up = q * up_radar_.cast<T>();
    const Eigen::Matrix<T, 3, 1> offset = t - t_reference_.cast<T>();
    residuals[0] = axes_.row(0).cast<T>().dot(up);
    residuals[1] = axes_.row(1).cast<T>().dot(up);
    residuals[2] = axes_.row(2).cast<T>().dot(offset);
    return true;
  }

  static ceres::CostFunction* Create(const Eigen::Vector3d& up_radar,
                                     const Eigen::Vector3d& up_submap,
                                     const Eigen::Vector3d& t_reference,
                                     double sigma_angle,
                                     double sigma_height) {
    return new ceres::AutoDiffCostFunction<AttitudeHeightPriorFactor,
                                           3 /* residuals */,
                                           7 /* pose */>(
        new AttitudeHeightPriorFactor(up_radar, up_submap, t_reference, sigma_angle, sigma_height));
  }

 private:
  const Eigen::Vector3d up_radar_;
  const Eigen::Vector3d t_reference_;
  Eigen::Matrix3d axes_;
};

}  // namespace radive
