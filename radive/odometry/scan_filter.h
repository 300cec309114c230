// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/ego_velocity/ego_velocity_estimator.h"
#include "radive/geometry/gaussian3.h"
#include "radive/odometry/odometry_options.h"
#include "radive/odometry/odometry_result.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// The returns of a scan that registration works with.
struct FilteredScan {
  std::vector<RadarReturn> returns;  // corrected, radar frame
  std::vector<double> weights;       // velocity-discrepancy weights, one a return
  bool is_planar = false;            // of a sensor without elevation
};

// The Gaussians of a scan, radar frame: of its returns or of its voxels, as options.ndt says.
std::vector<Gaussian3> GaussiansOfScan(const FilteredScan& scan, const OdometryOptions& options);

// Ego velocity of a scan that carries Doppler is measured, or the last good one, whose covariance
// has grown since.
inline bool HasVelocity(const EgoVelocity& velocity) {
  return velocity.valid || !velocity.covariance.isZero(0.0);
}

// From a scan to its static returns: correction and gates, ego velocity, removal of what moves and
// of what lies behind other returns, azimuth bins (first, if preprocessing.azimuth_bin_order says
// so), weights. One for each radar.
class ScanFilter {
 public:
  // `sensor`: the sensor options of this radar.
  ScanFilter(const OdometryOptions& options, const SensorOptions& sensor)
      : options_(options), ego_velocity_(options.ego_velocity, sensor, options.occlusion) {}

  // Writes ego_velocity, num_kept, dropped and the times of both stages to `result`.
  FilteredScan Filter(const RadarScan& scan, OdometryResult* result);

 private:
  std::vector<RadarReturn> StaticReturns(const std::vector<RadarReturn>& returns,
                                         const Eigen::Vector3d& v_radar,
                                         DropCounts* dropped) const;

  const OdometryOptions options_;
  EgoVelocityEstimator ego_velocity_;
};

}  // namespace radive
