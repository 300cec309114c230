// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "radive/simulation/radar_world.h"
#include "radive/simulation/street_path.h"
#include "radive/simulation/terrain.h"
#include "radive/simulation/vehicle_motion.h"

namespace radive {

// The other cars on the loop: some ahead in the lane of the radar's car, which keep a distance
// that grows with its speed, and the rest on the oncoming lane.
class Traffic {
 public:
  struct Options {
    int num_cars = 10;           // every fifth (and at least one) drives ahead
    double lead_gap = 20.0;      // standing, from the rear axle to the centre of the first [m]
    double lead_headway = 1.6;   // what its distance grows by with speed [s]
    bool lead_is_truck = false;  // the first of those ahead
  };

  // `path` and `terrain` must outlive this object.
  Traffic(const StreetPath& path,
          const Terrain& terrain,
          const Options& options,
          std::uint64_t seed);

  // Where the cars are at `time` [s], when the radar's car has travelled as `ego` says.
  std::vector<MovingCar> CarsAt(double time, const VehicleMotion::Travel& ego) const;

 private:
  struct Oncoming {
    double start = 0.0;      // arc length at time 0 [m]
    double amplitude = 0.0;  // of the variation of its position [m]
    double frequency = 0.0;  // [rad/s]
    double phase = 0.0;      // [rad]
  };

  MovingCar Place(double s, double s_rate, double lateral) const;

  const StreetPath& path_;
  const Terrain& terrain_;
  const Options options_;
  int num_ahead_ = 0;
  std::vector<Oncoming> oncoming_;
};

}  // namespace radive
