// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "radive/neural_map/surface_record.h"
#include "radive/odometry/odometry_options.h"
#include "radive/odometry/odometry_result.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// A surface that one radar has learned, in the frame `map`, and where that was at its last scan.
struct RadarSurface {
  Rigid3 T_world_map;
  SurfaceRecord record;
};

// Radar odometry: feed the scans of a drive in order, get the pose of the radar after each. Scans
// may be of several radars of one vehicle (RadarScan::radar, sensor.mounts): each has an odometry
// of its own, and what these say of the vehicle's motion is averaged (see MotionFusion).
//
//   radive::Odometry odometry(options);
//   for (const radive::RadarScan& scan : scans) {
//     const radive::OdometryResult result = odometry.AddScan(scan);
//   }
//
// Causal and deterministic: a result depends on the scans so far and on the options, never on
// timing or on the number of threads.
class Odometry {
 public:
  // `options` must be valid (OdometryOptions::IsValid).
  explicit Odometry(const OdometryOptions& options);
  ~Odometry();
  Odometry(Odometry&&) noexcept;
  Odometry& operator=(Odometry&&) noexcept;

  // Never fails: a scan that cannot be used is reported in the result's status and reason.
  OdometryResult AddScan(const RadarScan& scan);

  // Velocity of a radar, in its frame [m/s], to predict its next scan from. Only where its own
  // motion is not known: no scan of it was registered yet, or none lately, and without Doppler.
  void StartMotion(int radar, const Eigen::Vector3d& v_radar);

  // Remarks worth a line in the log ("scans carry no Doppler: ego velocity and weights are off").
  // Cleared by the call.
  std::vector<std::string> TakeNotes();

  // What makes the poses doubtful: gaps in which no radar gave a scan, and what was done about
  // them. Cleared by the call.
  std::vector<std::string> TakeWarnings();

  // What the neural submaps have learned of the surface over the whole drive: for maps, at the end
  // of a drive. Empty unless options.sdf_submap.record is set, and of radars whose submap stayed
  // raw. Ends the recording.
  std::vector<RadarSurface> TakeSurfaces();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace radive
