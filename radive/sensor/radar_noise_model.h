// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "radive/sensor/sensor_options.h"

namespace radive {

// Covariance of a measured position in the radar frame [m^2]: the noise of range r, azimuth and
// elevation, each along its own direction,
//
//   sigma_range^2 d d' + (r cos(el) sigma_azimuth)^2 a a' + (r sigma_elevation)^2 e e'
//
// d, a, e  unit vectors along the ray, to the left, and upwards across it
//
// A planar sensor measures no elevation; its third variance, along z, is sigma_range^2, so that the
// matrix stays positive definite at a sensible scale. A return at the origin gets sigma_range^2 I.
inline Eigen::Matrix3d PositionCovariance(const Eigen::Vector3d& p_radar,
                                          const SensorOptions& sensor,
                                          bool is_planar = false) {
  const double range_variance = sensor.sigma_range * sensor.sigma_range;
  const double range = p_radar.norm();
  if (!(range > 0.0)) return range_variance * Eigen::Matrix3d::Identity();

  const double planar = p_radar.head<2>().norm();
  const bool is_vertical = !(planar > 0.0);  // then the azimuth is taken as 0
  const double cos_azimuth = is_vertical ? 1.0 : p_radar.x() / planar;
  const double sin_azimuth = is_vertical ? 0.0 : p_radar.y() / planar;
  const double cos_elevation = planar / range, sin_elevation = p_radar.z() / range;
  Eigen::Matrix3d axes;  // columns d, a, e
  axes << cos_elevation * cos_azimuth, -sin_azimuth, -sin_elevation * cos_azimuth,  //
      cos_elevation * sin_azimuth, cos_azimuth, -sin_elevation * sin_azimuth,       //
      sin_elevation, 0.0, cos_elevation;
  const double sigma_across = range * cos_elevation * sensor.sigma_azimuth;
  const double sigma_up = is_planar ? sensor.sigma_range : range * sensor.sigma_elevation;
  const Eigen::Vector3d variances(range_variance, sigma_across * sigma_across, sigma_up * sigma_up);
  return axes * variances.asDiagonal() * axes.transpose();
}

}  // namespace radive
