// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace radive {

enum class VehicleType {
  kCar,
  kHandcart,  // pushed at walking speed over rough paving: it rocks, sways and swings
};

// How a simulated vehicle drives.
struct VehicleStyle {
  // Deviations from the smooth path, each the sum of a long wave of this amplitude and a short one
  // of 0.4 times it, over the arc length.
  double pitch = 0.004;      // [rad]
  double roll = 0.005;       // [rad]
  double heave = 0.02;       // [m]
  double yaw = 0.0;          // [rad]
  double sway = 0.0;         // sideways [m]
  double long_wave = 40.0;   // longest [m]; down to half of it
  double short_wave = 13.3;  // longest [m]; down to three fifths of it

  double max_lateral_acceleration = 2.2;  // [m/s^2]; tracking adds up to 15 %
  double planned_braking = 1.3;           // [m/s^2]
  double max_acceleration = 1.8;          // [m/s^2]
  double max_braking = 3.0;               // [m/s^2]
  double max_jerk = 4.0;                  // [m/s^3]
  double response_time = 0.6;             // of the driver [s]
};

const VehicleStyle& StyleOf(VehicleType type);

// The words for VehicleType in settings, in its order.
const std::vector<std::string>& VehicleNames();

}  // namespace radive
