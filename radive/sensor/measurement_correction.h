// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>

#include "radive/geometry/spherical.h"
#include "radive/sensor/sensor_options.h"

namespace radive {

// Whether the sensor's calibration changes positions at all.
inline bool NeedsCorrection(const SensorOptions& sensor) {
  return sensor.range_scale != 1.0 || sensor.azimuth_scale != 1.0 || sensor.azimuth_offset != 0.0;
}

// Position of a return in the radar frame [m] after the sensor's calibration of range and azimuth.
// The elevation stays, so planar returns stay planar. The very same numbers when nothing is set.
inline Eigen::Vector3d CorrectPosition(const Eigen::Vector3d& p_radar,
                                       const SensorOptions& sensor) {
  if (!NeedsCorrection(sensor)) return p_radar;
  if (sensor.azimuth_scale == 1.0) {  // a rotation
    const double cosine = std::cos(sensor.azimuth_offset), sine = std::sin(sensor.azimuth_offset);
    return sensor.range_scale * Eigen::Vector3d(cosine * p_radar.x() - sine * p_radar.y(),
                                                sine * p_radar.x() + cosine * p_radar.y(),
                                                p_radar.z());
  }
  Spherical s = ToSpherical(p_radar);
  s.range *= sensor.range_scale;
  s.azimuth = sensor.azimuth_scale * s.azimuth + sensor.azimuth_offset;
  return FromSpherical(s);
}

}  // namespace radive
