// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/odometry.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "radive/geometry/pose_covariance.h"
#include "radive/odometry/body_motion.h"
#include "radive/odometry/scan_filter.h"
#include "radive/odometry/submap.h"
#include "radive/registration/ndt_registration.h"
#include "radive/util/stopwatch.h"

namespace radive {
namespace {

double Seconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

}  // namespace

const char* ToString(OdometryResult::Status status) {
  switch (status) {
    case OdometryResult::Status::kRegistered:
      return "registered";
    case OdometryResult::Status::kPredicted:
      return "predicted";
    case OdometryResult::Status::kStanding:
      return "standing";
    case OdometryResult::Status::kSkipped:
      return "skipped";
  }
  return "unknown";
}

class Odometry::Impl {
 public:
  explicit Impl(const OdometryOptions& options) : options_(options), motion_(options) {
    std::string error;
    CHECK(options.IsValid(&error)) << error;
  }

  OdometryResult AddScan(const RadarScan& scan);

  std::vector<std::string> notes_;

 private:
  struct Radar {
    Radar(const OdometryOptions& options, const SensorOptions& sensor, const RadarMotion& motion_)
        : motion(motion_), filter(options, sensor), submap(MakeSubmap(options)) {}

    RadarMotion motion;
    ScanFilter filter;
    // Of its own keyframes: what two radars measure of the same wall differs by their azimuth
    // errors, and a scan drawn to the other's wall turns the vehicle.
    std::unique_ptr<Submap> submap;
    std::optional<Rigid3> T_world_keyframe;  // T_world_radar of its last keyframe
  };

  Radar* RadarOf(const RadarScan& scan);
  // "stamp repeats" or "stamp goes back" when the scan cannot follow the last one.
  std::string WhyOutOfOrder(const RadarScan& scan, const Radar& radar) const;
  void NoteMissingDoppler(const RadarScan& scan);
  void Locate(const Radar& radar,
              const RadarScan& scan,
              const FilteredScan& filtered,
              const ScanInterval& interval,
              OdometryResult* result);
  void Register(const Radar& radar,
                const FilteredScan& filtered,
                const MotionPrediction& prediction,
                double dt,
                OdometryResult* result);
  bool IsKeyframe(const Radar& radar, const OdometryResult& result) const;
  void AddKeyframe(FilteredScan filtered, Radar* radar, OdometryResult* result);

  const OdometryOptions options_;
  BodyMotion motion_;
  std::map<int, Radar> radars_;  // by the number that scans give
  int num_scans_ = 0;
  std::optional<std::int64_t> last_stamp_ns_;  // of any radar
  bool has_noted_doppler_ = false;
};

Odometry::Impl::Radar* Odometry::Impl::RadarOf(const RadarScan& scan) {
  const auto known = radars_.find(scan.radar);
  if (known != radars_.end()) return &known->second;
  const SensorOptions sensor = options_.sensor.ForRadar(scan.radar);
  Radar radar(options_, sensor, motion_.AddRadar(sensor.T_vehicle_radar()));
  return &radars_.emplace(scan.radar, std::move(radar)).first->second;
}

std::string Odometry::Impl::WhyOutOfOrder(const RadarScan& scan, const Radar& radar) const {
  if (!last_stamp_ns_ || scan.stamp_ns > *last_stamp_ns_) return "";
  if (scan.stamp_ns < *last_stamp_ns_) return "stamp goes back";
  // Two radars may measure at the same time.
  return radar.motion.has_scan && scan.stamp_ns == radar.motion.stamp_ns ? "stamp repeats" : "";
}

void Odometry::Impl::NoteMissingDoppler(const RadarScan& scan) {
  if (has_noted_doppler_ || (scan.has_doppler && options_.ego_velocity.enabled)) return;
  has_noted_doppler_ = true;
  notes_.push_back(scan.has_doppler
                       ? "ego velocity is switched off: no dynamic filter, no weights"
                       : "scans carry no Doppler: ego velocity, dynamic filter and weights are "
                         "off");
}

void Odometry::Impl::Register(const Radar& radar,
                              const FilteredScan& filtered,
                              const MotionPrediction& prediction,
                              double dt,
                              OdometryResult* result) {
  const Stopwatch stopwatch;
  const std::vector<Gaussian3> gaussians = GaussiansOfScan(filtered, options_);
  result->num_gaussians = static_cast<int>(gaussians.size());
  const double gap =
      std::max(0.0, motion_.time_since_registered() + dt - radar.motion.usual_interval);
  const double growth = options_.motion.gap_slack_rate * gap;
  const double slack = options_.pairs.slack + growth;
  RegistrationOptions registration_options = options_.registration;
  registration_options.max_correction += growth;
  registration_options.max_rotation_correction += kUnseenRotationRate * gap;
  const RegistrationResult registration = RegisterNdt(
      gaussians,
      *radar.submap->search(),
      prediction.T_world_radar,
      slack,
      motion_.Priors(radar.motion, prediction, result->ego_velocity, filtered.is_planar, dt),
      options_.pairs,
      registration_options);
  result->num_pairs = registration.num_pairs;
  result->num_iterations = registration.num_iterations;
  result->cost = registration.cost;
  result->degenerate = registration.degenerate();
  result->T_world_radar = registration.T_submap_radar;
  const Rigid3 T_radar_body = radar.motion.T_body_radar.Inverse();
  result->covariance = CovarianceAtLever(registration.covariance,
                                         result->T_world_radar.rotation * T_radar_body.translation);
  result->status = registration.converged ? OdometryResult::Status::kRegistered
                                          : OdometryResult::Status::kPredicted;
  result->reason = registration.message;
  motion_.LearnSlip(radar.motion, prediction, dt, registration);
  result->times_ms.pair_search = registration.pair_search_ms;
  result->times_ms.registration = stopwatch.Milliseconds() - registration.pair_search_ms;
}

// The pose of the scan: status, reason, T_world_radar and covariance of `result`.
void Odometry::Impl::Locate(const Radar& radar,
                            const RadarScan& scan,
                            const FilteredScan& filtered,
                            const ScanInterval& interval,
                            OdometryResult* result) {
  const EgoVelocity& velocity = result->ego_velocity;
  const MotionPrediction prediction = motion_.Predict(radar.motion, velocity, interval);
  // What stands now may have moved since the last pose, when that is some scans ago.
  const double usual_interval = radar.motion.usual_interval;
  const bool may_have_moved =
      usual_interval > 0.0 &&
      motion_.time_since_registered() + interval.dt > 1.5 * usual_interval &&
      motion_.speed() >= options_.ego_velocity.standing_speed;
  if (radar.submap->search() == nullptr) {
    // Nothing to register against yet: the first scan with enough returns starts the submap.
    result->T_world_radar = prediction.T_world_radar;
    result->covariance = motion_.covariance();
    const bool can_start =
        static_cast<int>(filtered.returns.size()) >= options_.registration.min_gaussians;
    result->status =
        can_start ? OdometryResult::Status::kRegistered : OdometryResult::Status::kPredicted;
    if (!can_start) {
      result->reason = std::to_string(filtered.returns.size()) + " returns left, " +
                       std::to_string(options_.registration.min_gaussians) + " needed";
    }
  } else if (velocity.is_standing && !may_have_moved) {
    result->status = OdometryResult::Status::kStanding;
    result->reason = "standing";
    result->T_world_radar = motion_.T_world_body() * radar.motion.T_body_radar;
    result->covariance = motion_.covariance();
  } else {
    Register(radar, filtered, prediction, interval.dt, result);
  }
  if (result->status != OdometryResult::Status::kPredicted) return;
  result->covariance = motion_.PredictedCovariance(radar.motion, velocity, interval.dt);
  if (!velocity.valid && scan.has_doppler && options_.ego_velocity.enabled &&
      !velocity.reason.empty()) {
    result->reason = "ego velocity: " + velocity.reason;
  }
}

bool Odometry::Impl::IsKeyframe(const Radar& radar, const OdometryResult& result) const {
  // Where the radar has seen nothing of its submap for long, the submap goes on at the prediction:
  // waiting for the old one would be forever.
  const bool is_lost = result.status == OdometryResult::Status::kPredicted &&
                       result.num_gaussians >= options_.registration.min_gaussians &&
                       radar.motion.time_since_registered > options_.motion.restart_time;
  if (result.status != OdometryResult::Status::kRegistered && !is_lost) return false;
  if (!radar.T_world_keyframe) return true;
  const Rigid3 T_keyframe_radar = radar.T_world_keyframe->Inverse() * result.T_world_radar;
  return T_keyframe_radar.translation.norm() > options_.submap.keyframe_distance ||
         RotationVector(T_keyframe_radar.rotation).norm() > options_.submap.keyframe_rotation;
}

void Odometry::Impl::AddKeyframe(FilteredScan filtered, Radar* radar, OdometryResult* result) {
  result->is_keyframe = true;
  radar->T_world_keyframe = result->T_world_radar;
  result->keyframe_points.reserve(filtered.returns.size());
  for (const RadarReturn& radar_return : filtered.returns) {
    result->keyframe_points.push_back(result->T_world_radar * radar_return.position);
  }
  radar->submap->AddKeyframe({result->T_world_radar,
                              std::move(filtered.returns),
                              std::move(filtered.weights),
                              filtered.is_planar});
}

OdometryResult Odometry::Impl::AddScan(const RadarScan& scan) {
  const Stopwatch stopwatch;
  Radar* const radar = RadarOf(scan);
  OdometryResult result;
  result.index = num_scans_++;
  result.stamp_ns = scan.stamp_ns;
  result.num_returns = static_cast<int>(scan.returns.size());
  result.T_world_body = motion_.T_world_body();
  result.T_world_radar = motion_.T_world_body() * radar->motion.T_body_radar;
  result.reason = WhyOutOfOrder(scan, *radar);
  if (!result.reason.empty()) {
    result.status = OdometryResult::Status::kSkipped;
    result.times_ms.total = stopwatch.Milliseconds();
    return result;
  }
  ScanInterval interval;
  if (last_stamp_ns_) interval.dt = Seconds(scan.stamp_ns - *last_stamp_ns_);
  if (radar->motion.has_scan) interval.own_dt = Seconds(scan.stamp_ns - radar->motion.stamp_ns);

  const Stopwatch handover_stopwatch;
  radar->submap->NextScan();
  result.times_ms.submap = handover_stopwatch.Milliseconds();
  for (std::string& note : radar->submap->TakeNotes()) notes_.push_back(std::move(note));
  motion_.Advance(interval.dt);
  NoteMissingDoppler(scan);
  FilteredScan filtered = radar->filter.Filter(scan, &result);
  Locate(*radar, scan, filtered, interval, &result);
  result.T_world_body = result.T_world_radar * radar->motion.T_body_radar.Inverse();
  motion_.Follow(result, interval, &radar->motion);
  last_stamp_ns_ = scan.stamp_ns;

  const Stopwatch submap_stopwatch;
  if (IsKeyframe(*radar, result)) AddKeyframe(std::move(filtered), radar, &result);
  result.times_ms.submap += submap_stopwatch.Milliseconds();
  result.times_ms.total = stopwatch.Milliseconds();
  return result;
}

Odometry::Odometry(const OdometryOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Odometry::~Odometry() = default;
Odometry::Odometry(Odometry&&) noexcept = default;
Odometry& Odometry::operator=(Odometry&&) noexcept = default;

OdometryResult Odometry::AddScan(const RadarScan& scan) { return impl_->AddScan(scan); }
std::vector<std::string> Odometry::TakeNotes() { return std::exchange(impl_->notes_, {}); }

}  // namespace radive
