// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/scans/scan_lookahead.h"
#include "radive/io/scans/scan_source.h"
#include "radive/sensor/sensor_options.h"

namespace radive {

// Finds out whether the Doppler of `source` has the canonical sign (positive receding), for
// input.doppler_sign: auto, and turns it where it has not.
//
// A velocity fit with the wrong sign is exactly the negative velocity and fits as well, so the
// residuals tell nothing. What tells is that vehicles drive forward: the median forward component
// of the radar's velocity over the moving scans among the first kMaxScans. Those scans are held
// back until the decision, which is made before the first of them is delivered. A drive that
// starts in reverse needs the sign set by hand.
class DopplerSignSource : public ScanSource {
 public:
  static constexpr std::size_t kMaxScans = 100;

  // `sensor` tells where the front of the vehicle is, seen from each of its radars.
  DopplerSignSource(ScanSource* source, const SensorOptions& sensor)
      : source_(source), ahead_(source), sensor_(sensor) {}

  Status Next(RadarScan* scan) override;
  std::string Description() const override { return source_->Description(); }
  std::optional<int> NumScans() const override { return source_->NumScans(); }

  // +1 or -1; +1 until the first scan is delivered.
  double sign() const { return sign_; }

  // Whether the evidence sufficed. Without it the Doppler is taken as stored.
  bool is_decided() const { return is_decided_; }

  // What the decision rests on, for the log; empty before the first scan.
  const std::string& evidence() const { return evidence_; }

 private:
  void Decide();
  // Of the vehicle's velocity, but for what its turning adds [m/s].
  double ForwardSpeed(const RadarScan& scan, const Eigen::Vector3d& v_radar) const;

  ScanSource* const source_;
  ScanLookahead ahead_;
  const SensorOptions sensor_;
  bool has_looked_ = false;
  double sign_ = 1.0;
  bool is_decided_ = false;
  std::string evidence_;
};

// Velocity of the radar in the radar frame from the Doppler as stored [m/s]; none when the returns
// do not agree on one. Of `sensor` only what a Doppler that wraps needs is looked at: its span, and
// where the front of the vehicle is.
std::optional<Eigen::Vector3d> FitVelocity(const RadarScan& scan,
                                           const SensorOptions& sensor = SensorOptions());

}  // namespace radive
