// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "radive/geometry/rigid3.h"

namespace radive {

// What registration of one scan found.
struct RegistrationResult {
  Rigid3 T_submap_radar;

  // Order [rotation vector (3), translation (3)], both in the submap frame: the true pose is
  // (exp(dr) R, t + dt). Units rad^2, rad m, m^2. The sandwich covariance of the M-estimator,
  // curvature^-1 (sum of squared gradients) curvature^-1: it follows the scatter that the pairs
  // show. Errors of the submap itself are not in it. In planar mode the directions that are held
  // have zero variance.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();

  bool converged = false;
  std::string message;  // why it is not converged

  int num_pairs = 0;       // of the last association
  int num_iterations = 0;  // LM steps, all associations together
  double cost = 0.0;       // final, without the condensed block's constant

  // Directions of the tangent space (same order) that the scan alone leaves unobserved or in which
  // its pairs pull against each other, as along a bare wall; unit vectors in rotation or
  // translation.
  std::vector<Eigen::Matrix<double, 6, 1>> weak_directions;
  bool degenerate() const { return !weak_directions.empty(); }

  // With a no-slip prior: what remains of its residual, and the variance that all else leaves in
  // the lateral displacement, from which the vehicle's slip is followed.
  double lateral_residual = 0.0;  // [m]
  double lateral_variance = 0.0;  // [m^2]

  double pair_search_ms = 0.0;
};

}  // namespace radive
