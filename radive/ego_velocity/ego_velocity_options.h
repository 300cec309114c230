// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// Velocity of the radar from the Doppler of one scan, and what follows from it for the returns.
struct EgoVelocityOptions {
  enum class Hypotheses {
    kPlanar,   // from two returns, without vertical velocity
    kSpatial,  // from three returns, in three dimensions (paper)
  };

  bool enabled = true;

  // What RANSAC draws. Samples of three are ill-conditioned at the elevations of most radars.
  Hypotheses hypotheses = Hypotheses::kPlanar;

  // Largest Doppler residual of a return that the velocity is fitted to [m/s].
  double fit_gate = 0.3;

  // Largest Doppler residual of a return that registration gets to see [m/s].
  double keep_gate = 0.5;

  // Standard deviation of the angles as far as they matter for the Doppler [rad]: a return across
  // the direction of travel shows them by |d x v| times this, and its gates and its noise grow by
  // sqrt(1 + (|d x v| sigma_angle / sigma_doppler)^2). 0: all returns alike.
  double sigma_angle = 0.0;

  // Largest change of the horizontal velocity since the last good fit: a constant part, for noise
  // and for stamps that are a little off, and a part that grows with time. Without it a passing
  // car that owns most of the returns is taken for the street.
  double temporal_gate = 1.5;     // [m/s]; 0: no gate
  double max_acceleration = 8.0;  // [m/s^2]

  // Where the Doppler wraps (sensor.doppler_span) and no earlier velocity tells how often: the
  // largest speed that is tried [m/s].
  double max_speed = 40.0;

  int num_draws = 60;  // hypotheses of RANSAC
  int seed = 1;        // of the draws

  // A fit needs at least this share and this number of the returns.
  double min_inlier_share = 0.2;  // [-]
  int min_inliers = 5;

  // A fit whose standard deviation is larger than this in any horizontal direction is none: the
  // returns then lie too close to one line of sight [m/s].
  double max_sigma = 0.5;

  // Radars hardly see how fast they climb. The velocity along the vehicle's vertical is drawn to
  // zero with the information of this share of the inliers [-]; its true size is taken to be
  // vertical_sigma [m/s], which enters the covariance.
  double vertical_ridge = 0.1;
  double vertical_sigma = 0.2;

  // Standard deviation of the errors that all returns of a scan share, such as those of the angle
  // calibration [m/s]. Added to the covariance in quadrature, on each axis.
  double common_sigma = 0.01;

  // Below this horizontal speed the radar counts as standing [m/s].
  double standing_speed = 0.05;

  // Weight exp(-|residual| / discrepancy_scale) of each kept return, or 1.
  bool weights = true;
  double discrepancy_scale = 1.0;  // [m/s]

  std::vector<OptionField> Fields();

  // True when all fields are in range; otherwise says in `error` which is not, and the rule.
  bool IsValid(std::string* error) const;
};

}  // namespace radive
