// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace radive {

// Spherical coordinates of a point in the sensor frame (paper, preprocessing section).
struct Spherical {
  double range = 0.0;      // [m], >= 0
  double azimuth = 0.0;    // [rad] in [-pi, pi], positive to the left
  double elevation = 0.0;  // [rad] in [-pi/2, pi/2], positive up
};

inline Spherical ToSpherical(const Eigen::Vector3d& p) {
  Spherical s;
  s.range = p.norm();
  if (s.range > 0.0) {
    s.azimuth = std::atan2(p.y(), p.x());
    s.elevation = std::asin(std::clamp(p.z() / s.range, -1.0, 1.0));
  }
  return s;
}

inline Eigen::Vector3d FromSpherical(const Spherical& s) {
  const double planar = s.range * std::cos(s.elevation);
  return {
      planar * std::cos(s.azimuth), planar * std::sin(s.azimuth), s.range * std::sin(s.elevation)};
}

}  // namespace radive
