// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/geometry/rigid3.h"
#include "radive/util/option_field.h"

namespace radive {

// The radar: its noise, its calibration, and where it sits on the vehicle.
struct SensorOptions {
  // Standard deviations of one measurement.
  double sigma_range = 0.15;         // [m]
  double sigma_azimuth = 0.01745;    // [rad]
  double sigma_elevation = 0.02618;  // [rad]
  double sigma_doppler = 0.1;        // [m/s]

  // The sensor measures range rates but for multiples of this: 2 v_max of its waveform. 0: it has
  // no such ambiguity within the velocities that occur [m/s].
  double doppler_span = 0.0;

  // Calibration of measured returns, in FLU spherical coordinates of the radar frame:
  //   range = range_scale * measured,  azimuth = azimuth_scale * measured + azimuth_offset
  double range_scale = 1.0;     // [-]
  double azimuth_scale = 1.0;   // [-]
  double azimuth_offset = 0.0;  // [rad], positive to the left

  // T_vehicle_radar; vehicle frame: origin at the rear axle, FLU. The rotation is
  // Rz(yaw) Ry(pitch) Rx(roll), so a positive pitch looks down.
  double mount_x = 0.0;      // [m]
  double mount_y = 0.0;      // [m]
  double mount_z = 0.0;      // [m]
  double mount_roll = 0.0;   // [rad]
  double mount_pitch = 0.0;  // [rad]
  double mount_yaw = 0.0;    // [rad]

  // Vehicles with several radars: rows of seven, the radar's number as the dataset counts it and
  // its mount_x, mount_y, mount_z [m], mount_roll, mount_pitch, mount_yaw [rad].
  std::vector<double> mounts;

  Rigid3 T_vehicle_radar() const;

  // These options with mount_* set to the row of `mounts` for that radar, if there is one.
  SensorOptions ForRadar(int radar) const;

  std::vector<OptionField> Fields();

  // True when all fields are in range; otherwise says in `error` which is not, and the rule.
  bool IsValid(std::string* error) const;
};

}  // namespace radive
