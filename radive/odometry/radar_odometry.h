// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radive/odometry/innovation_gate.h"
#include "radive/odometry/motion_model.h"
#include "radive/odometry/odometry_options.h"
#include "radive/odometry/odometry_result.h"
#include "radive/odometry/scan_filter.h"
#include "radive/odometry/submap.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// Odometry of one radar: filters a scan, predicts its pose, registers it with the submap and adds
// keyframes to that.
class RadarOdometry {
 public:
  // `options` must be valid; options.sensor is this radar's.
  explicit RadarOdometry(const OdometryOptions& options);

  // The world frame is the radar's at the first scan, and the body is the radar: T_world_body is
  // left for the caller to fill in.
  OdometryResult AddScan(const RadarScan& scan);

  // See Odometry::StartMotion.
  void StartMotion(const Eigen::Vector3d& v_radar) { motion_.Start(v_radar); }

  // See Odometry::TakeSurfaces.
  std::optional<SurfaceRecord> TakeSurfaceRecord() {
    return submap_ == nullptr ? std::nullopt : submap_->TakeSurfaceRecord();
  }

  std::vector<std::string> TakeNotes() { return std::exchange(notes_, {}); }

  // What makes the poses doubtful, such as a gap between scans.
  std::vector<std::string> TakeWarnings() { return std::exchange(warnings_, {}); }

 private:
  // "stamp repeats" or "stamp goes back" when the scan cannot follow the last one.
  std::string WhyOutOfOrder(const RadarScan& scan) const;
  void NoteMissingDoppler(const RadarScan& scan);
  // The first scan that can start the submap says of what Gaussians, where the options do not.
  void PrepareSubmap(const FilteredScan& filtered);
  void Locate(const RadarScan& scan,
              const FilteredScan& filtered,
              double dt,
              OdometryResult* result);
  void Register(const FilteredScan& filtered,
                const MotionPrediction& prediction,
                double dt,
                OdometryResult* result);
  // Puts a registered scan back to its prediction when it contradicts the motion: true then.
  bool CheckInnovation(const MotionPrediction& prediction, double dt, OdometryResult* result);
  // Behind a gap in which the motion is unknown: registers the scan as if no time had passed, and
  // where it does not fit the submap as well as scans before did, starts the submap anew.
  void LocateBehindGap(const FilteredScan& filtered, double dt, OdometryResult* result);
  void WarnOfGap(double dt, const OdometryResult& result);
  // Adds to the reason of a scan that lost most of its returns where these went.
  void TellWhatIsDropped(OdometryResult* result) const;
  // Takes in how well a registered scan fits.
  void LearnFit(const OdometryResult& result);
  bool IsKeyframe(const OdometryResult& result) const;
  void AddKeyframe(FilteredScan filtered, OdometryResult* result);

  bool CanStart(const FilteredScan& filtered) const;

  OdometryOptions options_;
  MotionModel motion_;
  InnovationGate gate_;
  ScanFilter filter_;
  std::unique_ptr<Submap> submap_;          // null until it is known of what Gaussians
  std::optional<Rigid3> T_world_keyframe_;  // T_world_radar of the last keyframe
  std::optional<std::int64_t> last_stamp_ns_;
  int num_scans_ = 0;
  // How well registered scans fit, exponentially weighted: pairs and cost per Gaussian.
  bool has_fit_ = false;
  double usual_pairs_ = 1.0;
  double usual_cost_ = 0.0;
  bool has_noted_doppler_ = false;
  std::vector<std::string> notes_;
  std::vector<std::string> warnings_;
};

}  // namespace radive
