// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "radive/geometry/rigid3.h"
#include "radive/sensor/radar_scan.h"
#include "radive/simulation/radar_world.h"
#include "radive/simulation/sensor_model.h"
#include "radive/simulation/simulation_options.h"
#include "radive/simulation/street_path.h"
#include "radive/simulation/traffic.h"
#include "radive/simulation/vehicle_motion.h"
#include "radive/util/random.h"

namespace radive {

// What a simulated return really is. The values are those of the label files.
enum class ReturnLabel : std::uint8_t {
  kStatic = 0,     // first echo of the street, the parked cars included
  kGhost = 1,      // multipath: mirrored in a wall, or bounced twice between wall and car
  kMoving = 2,     // other road users, also while they stand
  kClutter = 3,    // noise peaks, and side lobes of a real return
  kDuplicate = 4,  // second return behind a real one
};
constexpr int kNumReturnLabels = 5;

// The truth beside a simulated scan.
struct GroundTruth {
  Rigid3 T_world_radar;                               // exact
  Eigen::Vector3d v_radar = Eigen::Vector3d::Zero();  // of the radar, in the radar frame [m/s]

  // One entry per return.
  std::vector<ReturnLabel> labels;

  // Where the return would be without noise, in the radar frame [m]: on the surface itself for
  // static and moving returns. Three-dimensional for planar sensors as well.
  std::vector<Eigen::Vector3d> noise_free_positions;
};

// Drives a radar through a street and delivers its scans. The same options give the same bytes;
// scan k does not depend on how many scans follow.
//
// Returns come from exact rays, drawn from the beam pattern of the sensor and kept with the
// probability of detection at their range, and from repeatable scatterers in view. A static
// return has the Doppler -d . v_radar of its true direction d, plus noise.
class RadarSimulator {
 public:
  // The options must be valid (SimulationOptions::IsValid).
  explicit RadarSimulator(const SimulationOptions& options);
  RadarSimulator(const RadarSimulator&) = delete;
  RadarSimulator& operator=(const RadarSimulator&) = delete;

  // The next scan and its truth; false after `options.frames` scans. Stamps begin at 0.
  bool Next(RadarScan* scan, GroundTruth* truth);

  const SimulationOptions& options() const { return options_; }
  const SensorModel& sensor() const { return sensor_; }
  const StreetPath& path() const { return path_; }
  const RadarWorld& world() const { return world_; }

  // Stamp of scan k [ns].
  std::int64_t StampOf(int k) const;

  // Arc length that the car has travelled at the time of scan k [m].
  double TravelledAt(int k);

 private:
  // A return before noise.
  struct Echo {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // radar frame [m]
    double doppler = 0.0;                                // [m/s]
    ReturnLabel label = ReturnLabel::kStatic;
  };
  // A wall that was hit, as a mirror; radar frame.
  struct Mirror {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();    // [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitX();  // unit, towards the radar
  };
  struct View;  // everything that holds for one scan

  void FindVisibleScatterers(View* view) const;
  bool DrawReturn(View* view, Echo* echo, RadarReturn* measured) const;
  bool DrawSurface(View* view, Echo* echo) const;
  bool DrawScatterer(View* view, Echo* echo) const;
  bool DrawGhost(View* view, Echo* echo) const;
  bool DrawClutter(View* view, Echo* echo) const;
  bool DrawDuplicate(View* view, Echo* echo) const;
  bool Measure(const Echo& echo, Random* random, RadarReturn* measured) const;
  double DetectionProbability(double range) const;

  const SimulationOptions options_;
  const SensorModel sensor_;
  const StreetPath path_;
  const RadarWorld world_;
  const Traffic traffic_;
  VehicleMotion motion_;
  const Rigid3 T_body_radar_;
  int next_scan_ = 0;
};

}  // namespace radive
