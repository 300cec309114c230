// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/doppler_sign.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "radive/ego_velocity/ego_velocity_estimator.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr double kMinSpeed = 1.0;    // of a moving scan [m/s]
constexpr double kMinForward = 0.5;  // median forward component that decides [m/s]
constexpr int kMinMovingScans = 5;
constexpr double kMinAgreement = 0.8;  // share of the moving scans that go the median's way

// Every scan by itself, and only those whose returns clearly agree: a few are enough to decide.
EgoVelocityOptions FitOptions() {
  EgoVelocityOptions options;
  options.fit_gate = 0.5;
  options.keep_gate = 0.5;
  options.temporal_gate = 0.0;
  options.min_inlier_share = 0.5;
  options.min_inliers = 8;
  options.vertical_ridge = 0.0;  // which way is up in the radar is not known here
  return options;
}

}  // namespace

double DopplerSignSource::ForwardSpeed(const RadarScan& scan,
                                       const Eigen::Vector3d& v_radar) const {
  return (sensor_.ForRadar(scan.radar).T_vehicle_radar().rotation * v_radar).x();
}

std::optional<Eigen::Vector3d> FitVelocity(const RadarScan& scan, const SensorOptions& sensor) {
  SensorOptions plain;
  if (sensor.doppler_span > 0.0) {
    plain.doppler_span = sensor.doppler_span;
    plain.mount_yaw = sensor.ForRadar(scan.radar).mount_yaw;
  }
  EgoVelocityEstimator estimator(FitOptions(), plain);
  const EgoVelocity fit = estimator.Estimate(scan.returns, scan.is_planar, scan.stamp_ns);
  if (!fit.valid) return std::nullopt;
  return fit.v_radar;
}

ScanSource::Status DopplerSignSource::Next(RadarScan* scan) {
  if (!has_looked_) {
    has_looked_ = true;
    ahead_.Read(kMaxScans);
    Decide();
  }
  const Status status = PassOn(ahead_.Next(scan), source_);
  if (status == Status::kScan && sign_ < 0.0) {
    for (RadarReturn& ret : scan->returns) ret.doppler = -ret.doppler;
  }
  return status;
}

void DopplerSignSource::Decide() {
  std::vector<double> forward;  // of the moving scans [m/s]
  bool has_doppler = false;
  for (const RadarScan& scan : ahead_.held_back()) {
    has_doppler = has_doppler || scan.has_doppler;
    const std::optional<Eigen::Vector3d> v_radar =
        scan.has_doppler ? FitVelocity(scan, sensor_) : std::nullopt;
    if (v_radar && v_radar->norm() > kMinSpeed) forward.push_back(ForwardSpeed(scan, *v_radar));
  }
  if (!has_doppler) {
    is_decided_ = true;  // nothing to turn
    evidence_ = "the scans carry no Doppler, so its sign does not matter";
    return;
  }
  const int moving = static_cast<int>(forward.size());
  std::sort(forward.begin(), forward.end());
  const double median = forward.empty() ? 0.0 : forward[forward.size() / 2];
  const auto agreeing = std::count_if(
      forward.begin(), forward.end(), [median](double v) { return v * median > 0.0; });
  is_decided_ = moving >= kMinMovingScans && std::abs(median) >= kMinForward &&
                static_cast<double>(agreeing) >= kMinAgreement * moving;
  if (is_decided_ && median < 0.0) sign_ = -1.0;
  evidence_ = FormatText(
      "Doppler sign %s: as stored, the median forward speed is %.2f m/s over %d moving "
      "of the first %d scans, %d of which agree",
      is_decided_ ? (sign_ < 0.0 ? "-1" : "+1") : "undecided, +1 assumed",
      median,
      moving,
      static_cast<int>(ahead_.held_back().size()),
      static_cast<int>(agreeing));
}

}  // namespace radive
