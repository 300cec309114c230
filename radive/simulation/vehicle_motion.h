// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "radive/geometry/rigid3.h"
#include "radive/simulation/street_path.h"
#include "radive/simulation/terrain.h"
#include "radive/simulation/vehicle_style.h"
#include "radive/util/random.h"

namespace radive {

// How the simulated vehicle moves along a StreetPath: it starts from rest, slows down for the
// corners, stops at traffic lights, and pitches, rolls and heaves a little over the road, which
// follows the terrain.
//
// The body frame sits on the ground under the middle of the rear axle, x forward, y left, z up.
// The rear axle does not slip sideways, so a radar ahead of it by l moves sideways with l times
// the yaw rate. Everything is a smooth function of time whose derivative is known exactly.
class VehicleMotion {
 public:
  struct Travel {
    double s = 0.0;             // arc length in the plane since the start, not wrapped [m]
    double speed = 0.0;         // ds/dt >= 0 [m/s]
    double acceleration = 0.0;  // [m/s^2]
  };

  struct BodyState {
    Rigid3 T_world_body;
    Eigen::Vector3d v_body = Eigen::Vector3d::Zero();      // velocity in the body frame [m/s]
    Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  // angular velocity, same frame [rad/s]
  };

  struct Options {
    VehicleStyle style;
    double max_speed = 12.0;     // [m/s], > 0
    double wobble = 1.0;         // factor on the deviations from the smooth path; 0: none
    double stop_distance = 0.0;  // mean distance of the places where it stops [m]; 0: once a lap
  };

  // `path` and `terrain` must outlive this object.
  VehicleMotion(const StreetPath& path,
                const Terrain& terrain,
                const Options& options,
                std::uint64_t seed);

  // `time` in seconds since the start, >= 0. Not const: the drive is integrated as far as asked.
  Travel TravelAt(double time);
  BodyState BodyAt(double time);

 private:
  // A zero-mean function of the arc length that repeats with every lap.
  struct Wave {
    double amplitude = 0.0;
    double wave_number = 0.0;  // [rad/m]
    double phase = 0.0;        // [rad]
  };
  using Waves = std::array<Wave, 2>;

  Waves MakeWaves(double amplitude, std::uint64_t seed) const;
  void ComputeSpeedLimits();
  double SpeedLimit(double s) const;
  void AppendKnot();

  const StreetPath& path_;
  const Terrain& terrain_;
  const Options options_;
  Random stops_;
  std::vector<double> speed_limits_;  // every kLimitStep along the loop [m/s]
  std::vector<Travel> knots_;         // every kKnotStep of time; speed is linear in between
  double next_stop_s_;                // where the next traffic light stands [m]
  double hold_until_ = 0.0;           // standing until this time [s]
  Waves pitch_, roll_, heave_, yaw_, sway_;
};

}  // namespace radive
