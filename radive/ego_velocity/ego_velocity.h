// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace radive {

// Velocity of the radar with respect to the world, in the radar frame, from one scan's Doppler.
struct EgoVelocity {
  bool valid = false;
  std::string reason;  // why it is not valid

  // When not valid: the last valid one, with a covariance grown by the time since; zero, with a
  // zero covariance, when there was none.
  Eigen::Vector3d v_radar = Eigen::Vector3d::Zero();     // [m/s]
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // [m^2/s^2]

  bool is_standing = false;   // valid, and slower than ego_velocity.standing_speed
  int num_inliers = 0;        // returns within the fit gate
  int num_returns = 0;        // returns that took part
  double residual_rms = 0.0;  // of the inliers [m/s]
};

}  // namespace radive
