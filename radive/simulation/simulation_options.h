// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/simulation/sensor_model.h"
#include "radive/simulation/vehicle_style.h"
#include "radive/simulation/world_style.h"
#include "radive/util/option_field.h"

namespace radive {

// What to simulate. Every field has a working default: the dense radar on the street loop.
struct SimulationOptions {
  SensorType sensor = SensorType::kOculii;
  int seed = 1;          // of the world, the traffic, the drive and all noise
  int frames = 1440;     // number of scans: about one lap of the dense sensor on the street
  double rate = 0.0;     // scans per second [Hz]; 0: the sensor's own
  double returns = 0.0;  // mean number of returns of a scan; 0: the sensor's own

  // Where the radar sits in the car frame (ground under the rear axle, x forward, y left, z up).
  std::vector<double> mount_position = {3.7, 0.0, 0.6};  // x, y, z [m]
  double mount_yaw = 0.0;                                // [rad], positive to the left

  WorldType world = WorldType::kStreet;
  VehicleType vehicle = VehicleType::kCar;
  double max_speed = 12.0;     // [m/s]
  double wobble = 1.0;         // factor on how the vehicle rocks; 0: a smooth drive
  double stop_distance = 0.0;  // mean distance of the places where it stops [m]; 0: once a lap

  int moving_cars = 14;        // other cars on the loop
  double lead_gap = 20.0;      // from the rear axle to the middle of the car ahead, standing [m]
  double lead_headway = 1.6;   // what that grows by with speed [s]
  bool lead_is_truck = false;  // the vehicle ahead

  // Shares of the returns that are not what they seem [-]; their sum must be below 1.
  double ghost_share = 0.04;         // multipath over walls and the own car
  double ground_ghost_share = 0.01;  // multipath over the ground
  double clutter_share = 0.025;      // noise peaks and side lobes
  double duplicate_share = 0.025;    // second returns behind the first
  double ambiguity_scale = 1.0;      // factor on the sensor's share of wrong elevations [-]
  double noise_scale = 1.0;          // factor on all standard deviations of the sensor [-]

  // Every `outage_period` seconds the sensor fails for `outage_length` [s]; 0: never. It then
  // gives this share of its returns; 0: no scan at all.
  double outage_period = 0.0;
  double outage_length = 2.0;
  double outage_returns = 0.0;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const;

  // The sensor's model with rate, count and noise as asked.
  SensorModel Sensor() const;
};

}  // namespace radive
