// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "radive/geometry/rigid3.h"
#include "radive/sensor/radar_scan.h"
#include "radive/simulation/ground_truth.h"
#include "radive/simulation/radar_world.h"
#include "radive/simulation/scan_sampler.h"
#include "radive/simulation/scenarios.h"
#include "radive/simulation/simulation_options.h"
#include "radive/simulation/street_path.h"
#include "radive/simulation/traffic.h"
#include "radive/simulation/vehicle_motion.h"

namespace radive {

// Drives a radar through a simulated world and delivers its scans. The same options give the same
// bytes; a scan does not depend on how many scans follow.
class RadarSimulator {
 public:
  // The options must be valid (SimulationOptions::IsValid).
  explicit RadarSimulator(const SimulationOptions& options);
  RadarSimulator(const RadarSimulator&) = delete;
  RadarSimulator& operator=(const RadarSimulator&) = delete;

  // The next scan and its truth; false after `options.frames` scans, those that an outage swallows
  // included. Stamps begin at 0.
  bool Next(RadarScan* scan, GroundTruth* truth);

  const SimulationOptions& options() const { return options_; }
  const SensorModel& sensor() const { return sampler_.sensor(); }
  const StreetPath& path() const { return path_; }
  const RadarWorld& world() const { return world_; }

  // When scan k is due, outages or not [ns].
  std::int64_t StampOf(int k) const;

  // Arc length that the vehicle has travelled at that time [m].
  double TravelledAt(std::int64_t stamp_ns);

 private:
  double ShareOfReturns(double time) const;

  const SimulationOptions options_;
  const StreetPath path_;
  const RadarWorld world_;
  const ScanSampler sampler_;
  const Traffic traffic_;
  VehicleMotion motion_;
  const Rigid3 T_body_radar_;
  int next_scan_ = 0;
};

}  // namespace radive
