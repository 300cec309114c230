// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "radive/geometry/spherical.h"
#include "radive/sensor/radar_scan.h"
#include "radive/util/random.h"

namespace radive::testing {

inline constexpr std::int64_t kTenthSecond = 100'000'000;  // [ns]

// A return in the plane of the radar [m], [m/s].
inline RadarReturn At(double x, double y, double doppler) {
  RadarReturn entry;
  entry.position = {x, y, 0.0};
  entry.doppler = doppler;
  return entry;
}

// Where the returns of MakeReturns() lie and how noisy their Doppler is.
struct ReturnsModel {
  double half_azimuth = 1.0;    // uniform in +- this [rad]
  double half_elevation = 0.2;  // uniform in +- this [rad]; 0: planar
  double sigma_doppler = 0.1;   // [m/s]
};

// Exact positions, and the Doppler of returns that move with `v_target` while the radar moves with
// `v_radar`, both in the radar frame [m/s].
inline std::vector<RadarReturn> MakeReturns(int count,
                                            const Eigen::Vector3d& v_radar,
                                            const Eigen::Vector3d& v_target,
                                            const ReturnsModel& model,
                                            Random* random) {
  std::vector<RadarReturn> returns(static_cast<std::size_t>(count));
  for (RadarReturn& entry : returns) {
    const double range = random->Uniform(5.0, 80.0);
    const double azimuth = random->Uniform(-model.half_azimuth, model.half_azimuth);
    const double elevation = random->Uniform(-model.half_elevation, model.half_elevation);
    entry.position = FromSpherical({range, azimuth, elevation});
    const Eigen::Vector3d direction = entry.position / range;
    entry.doppler = direction.dot(v_target - v_radar) + model.sigma_doppler * random->Normal();
  }
  return returns;
}

inline std::vector<RadarReturn> MakeStaticReturns(int count,
                                                  const Eigen::Vector3d& v_radar,
                                                  const ReturnsModel& model,
                                                  Random* random) {
  return MakeReturns(count, v_radar, Eigen::Vector3d::Zero(), model, random);
}

}  // namespace radive::testing
