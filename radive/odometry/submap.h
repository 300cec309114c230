// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/geometry/rigid3.h"
#include "radive/ndt/distance_bounded_pairs.h"
#include "radive/ndt/ndt_options.h"
#include "radive/neural_map/surface_record.h"
#include "radive/odometry/odometry_options.h"
#include "radive/odometry/submap_options.h"
#include "radive/sensor/radar_scan.h"
#include "radive/sensor/sensor_options.h"

namespace radive {

// A scan that the submap is made of.
struct Keyframe {
  Rigid3 T_world_radar;
  std::vector<RadarReturn> returns;  // filtered, radar frame
  std::vector<double> weights;       // velocity-discrepancy weights, one a return
  bool is_planar = false;            // of a sensor without elevation
};

// What a scan is registered against. Raw keyframe points now; extracted surface points can stand
// in for them.
class Submap {
 public:
  virtual ~Submap() = default;

  virtual void AddKeyframe(Keyframe keyframe) = 0;

  // Forgets all keyframes.
  virtual void Clear() = 0;

  // Called once before each scan: what is prepared beside registration is handed over by their
  // count.
  virtual void NextScan() {}

  // Remarks worth a line in the log; cleared by the call.
  virtual std::vector<std::string> TakeNotes() { return {}; }

  // What was learned of the surface over the whole drive; nothing when that was not asked for
  // (SdfSubmapOptions::record) or not learned. Ends the recording.
  virtual std::optional<SurfaceRecord> TakeSurfaceRecord() { return std::nullopt; }

  // Search over the Gaussians of the submap, world frame; nullptr before the first keyframe. Valid
  // until the next change.
  virtual const PairSearch* search() const = 0;
};

// The points of the last keyframes, as they were measured.
std::unique_ptr<Submap> MakeRawSubmap(const SubmapOptions& options,
                                      const NdtOptions& ndt,
                                      const SensorOptions& sensor);

// The submap that options.submap.type asks for.
std::unique_ptr<Submap> MakeSubmap(const OdometryOptions& options);

}  // namespace radive
