// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// How the next pose is predicted, and which of that is held as a prior in registration.
struct MotionOptions {
  enum class Body {
    kRadar,   // the radar of the first scan
    kVehicle  // origin at the rear axle, see SensorOptions
  };

  // Whose pose the trajectory is of. The body's frame at the first scan is the world frame.
  Body body = Body::kRadar;

  // Translation prior from the ego velocity, always on, weighted by the velocity's covariance.
  bool doppler_prior = true;
  double doppler_floor = 0.1;  // added to the velocity's standard deviation [m/s]

  // The paper's translation prior: lambda/2 |t - t_init|^2 below a speed. 0: off.
  double low_speed_lambda = 0.0;  // [1/m^2]
  double low_speed_limit = 1.5;   // [m/s]

  // Rotation prior at the prediction. 0: off.
  double rotation_sigma_rate = 0.0;  // standard deviation of the rate's change in a scan [rad/s]

  // No-slip prior of a road vehicle (NoSlipFactor). The radar's mounting says where the rear axle
  // is; it drifts outwards by slip_compliance [rad] for each m/s^2 of lateral acceleration, which
  // moves the point without slip ahead by slip_compliance * v^2.
  bool no_slip = false;
  double no_slip_sigma = 0.1;      // standard deviation of the lateral velocity at the axle [m/s]
  double no_slip_floor = 0.002;    // ... and of a scan's lateral displacement [m]
  double slip_compliance = 0.003;  // [rad s^2/m]

  // What else makes the vehicle move askew (bank of the road, error of the mounting angle) is
  // followed online as a slip angle of this size and correlation time.
  double slip_sigma = 0.00175;  // [rad]
  double slip_time = 10.0;      // [s]

  // Attitude and height prior of a road vehicle (AttitudeHeightPriorFactor). 0: off.
  double attitude_sigma = 0.0;  // of roll and pitch against the start [rad]
  double height_sigma = 0.0;    // of the height against the previous scan [m]

  // Growth of the prediction's error with the time since the last registered scan, beyond the
  // usual scan interval [m/s].
  double gap_slack_rate = 1.0;

  // Time without registration [s] after which the submap goes on with keyframes at predicted poses.
  double restart_time = 1.0;

  // Largest innovation of a registered scan, in multiples of the median (InnovationGate). 0: off.
  double innovation_gate = 5.0;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("motion", *this, error); }
};

}  // namespace radive
