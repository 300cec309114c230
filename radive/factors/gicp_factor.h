// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace radive {

// GICP factor, plane to plane: a point of the scan lies on its nearest neighbour in the submap, as
// far as the surfaces about both of them say.
//
//   r = W (R p + t - q),   W^T W = (R_a C_p R_a^T + C_q)^-1
//
// T_submap_radar = (R, t)  pose of the radar in the submap: maps p to the submap frame
// p, C_p                   point of the scan and covariance of its surface, radar frame   [m, m^2]
// q, C_q                   the same of its nearest neighbour, submap frame                [m, m^2]
// R_a                      R at the association. W is held: with it free, a step could turn the
//                          wide sides of the discs towards each other instead of closing the gap
//
// Parameter blocks: T_submap_radar [qx qy qz qw tx ty tz] (7). Residuals: 3, unit-free.
// Source: Segal et al. 2009 (Generalized-ICP), Eq. (2).
class GicpFactor {
 public:
  GicpFactor(const Eigen::Vector3d& p_radar,
             const Eigen::Vector3d& q_submap,
             const Eigen::Matrix3d& sqrt_information)
      : p_radar_(p_radar), q_submap_(q_submap), sqrt_information_(sqrt_information) {}

  template <typename T>
  bool operator()(const T* const pose, T* residuals) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q_submap_radar(pose);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t_submap_radar(pose + 4);
    Eigen::Map<Eigen::Matrix<T, 3, 1>> r(residuals);
    const Eigen::Matrix<T, 3, 1> gap =
        q_submap_radar * p_radar_.cast<T>() + t_submap_radar - q_submap_.cast<T>();
    r = sqrt_information_.cast<T>() * gap;
    return true;
  }

  static ceres::CostFunction* Create(const Eigen::Vector3d& p_radar,
                                     const Eigen::Vector3d& q_submap,
                                     const Eigen::Matrix3d& sqrt_information) {
    return new ceres::AutoDiffCostFunction<GicpFactor, 3 /* residuals */, 7 /* pose */>(
        new GicpFactor(p_radar, q_submap, sqrt_information));
  }

 private:
  const Eigen::Vector3d p_radar_;
  const Eigen::Vector3d q_submap_;
  const Eigen::Matrix3d sqrt_information_;
};

}  // namespace radive
