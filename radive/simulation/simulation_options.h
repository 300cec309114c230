// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radive/simulation/sensor_model.h"
#include "radive/util/option_field.h"

namespace radive {

// What to simulate. Every field has a working default: the dense radar on the street loop.
struct SimulationOptions {
  SensorType sensor = SensorType::kOculii;
  int seed = 1;       // of the street, the traffic, the drive and all noise
  int frames = 1440;  // number of scans: about one lap of the dense sensor
  double rate = 0.0;  // scans per second [Hz]; 0: the sensor's own

  // Where the radar sits in the car frame (ground under the rear axle, x forward, y left, z up).
  std::vector<double> mount_position = {3.7, 0.0, 0.6};  // x, y, z [m]
  double mount_yaw = 0.0;                                // [rad], positive to the left

  double max_speed = 12.0;  // [m/s]
  double wobble = 1.0;      // scale of pitch, roll and heave of the car [-]; 0: plane drive
  int moving_cars = 10;     // other cars on the loop

  // Shares of the returns that are not what they seem [-]; their sum must be below 1.
  double ghost_share = 0.055;      // multipath
  double clutter_share = 0.05;     // noise peaks and side lobes
  double duplicate_share = 0.025;  // second returns behind the first
  double noise_scale = 1.0;        // factor on all standard deviations of the sensor [-]

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const;

  // The sensor's model with rate and noise as asked.
  SensorModel Sensor() const;
};

// The named scenarios: "street_dense", "street_sparse", "street_planar".
const std::vector<std::string>& ScenarioNames();

// Options of a scenario; nothing when there is no such name.
std::optional<SimulationOptions> ScenarioOptions(const std::string& name);

}  // namespace radive
