// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/radar_odometry.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "radive/odometry/scan_filter.h"
#include "radive/odometry/submap.h"
#include "radive/registration/registration.h"
#include "radive/util/seconds.h"
#include "radive/util/stopwatch.h"

namespace radive {

RadarOdometry::RadarOdometry(const OdometryOptions& options)
    : options_(options),
      motion_(options),
      filter_(options, options.sensor),
      submap_(MakeSubmap(options)) {}

std::string RadarOdometry::WhyOutOfOrder(const RadarScan& scan) const {
  if (!last_stamp_ns_ || scan.stamp_ns > *last_stamp_ns_) return "";
  return scan.stamp_ns < *last_stamp_ns_ ? "stamp goes back" : "stamp repeats";
}

void RadarOdometry::NoteMissingDoppler(const RadarScan& scan) {
  if (has_noted_doppler_ || (scan.has_doppler && options_.ego_velocity.enabled)) return;
  has_noted_doppler_ = true;
  notes_.push_back(scan.has_doppler
                       ? "ego velocity is switched off: no dynamic filter, no weights"
                       : "scans carry no Doppler: ego velocity, dynamic filter and weights are "
                         "off");
}

void RadarOdometry::Register(const FilteredScan& filtered,
                             const MotionPrediction& prediction,
                             double dt,
                             OdometryResult* result) {
  const Stopwatch stopwatch;
  const std::vector<Gaussian3> gaussians = GaussiansOfScan(filtered, options_);
  result->num_gaussians = static_cast<int>(gaussians.size());
  const double gap = std::max(0.0, motion_.time_since_registered() + dt - motion_.usual_interval());
  const double growth = options_.motion.gap_slack_rate * gap;
  const double slack = options_.pairs.slack + growth;
  RegistrationOptions registration_options = options_.registration;
  registration_options.max_correction += growth;
  registration_options.max_rotation_correction += kUnseenRotationRate * gap;
  RegistrationInput input;
  input.scan = &gaussians;
  input.search = submap_->search();
  input.T_prediction = prediction.T_world_radar;
  input.slack = slack;
  input.is_planar = filtered.is_planar;
  input.priors = motion_.Priors(prediction, result->ego_velocity, filtered.is_planar, dt);
  if (prediction.has_doppler && dt > 0.0) {
    input.doppler = {&filtered.returns,
                     &filtered.weights,
                     motion_.T_world_radar(),
                     dt,
                     options_.sensor.sigma_doppler};
  }
  const RegistrationResult registration =
      radive::Register(input, options_.pairs, registration_options);
  result->num_pairs = registration.num_pairs;
  result->num_iterations = registration.num_iterations;
  result->cost = registration.cost;
  result->degenerate = registration.degenerate();
  result->T_world_radar = registration.T_submap_radar;
  result->covariance = registration.covariance;
  result->status = registration.converged ? OdometryResult::Status::kRegistered
                                          : OdometryResult::Status::kPredicted;
  result->reason = registration.message;
  motion_.LearnSlip(prediction, dt, registration);
  result->times_ms.pair_search = registration.pair_search_ms;
  result->times_ms.registration = stopwatch.Milliseconds() - registration.pair_search_ms;
}

// The pose of the scan: status, reason, T_world_radar and covariance of `result`.
void RadarOdometry::Locate(const RadarScan& scan,
                           const FilteredScan& filtered,
                           double dt,
                           OdometryResult* result) {
  const EgoVelocity& velocity = result->ego_velocity;
  const MotionPrediction prediction = motion_.Predict(velocity, dt);
  // What stands now may have moved since the last pose, when that is some scans ago.
  const double usual_interval = motion_.usual_interval();
  const bool may_have_moved = usual_interval > 0.0 &&
                              motion_.time_since_registered() + dt > 1.5 * usual_interval &&
                              motion_.speed() >= options_.ego_velocity.standing_speed;
  if (submap_->search() == nullptr) {
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
    result->T_world_radar = motion_.T_world_radar();
    result->covariance = motion_.covariance();
  } else {
    Register(filtered, prediction, dt, result);
  }
  if (result->status != OdometryResult::Status::kPredicted) return;
  result->covariance = motion_.PredictedCovariance(velocity, dt);
  if (!velocity.valid && scan.has_doppler && options_.ego_velocity.enabled &&
      !velocity.reason.empty()) {
    result->reason = "ego velocity: " + velocity.reason;
  }
}

bool RadarOdometry::IsKeyframe(const OdometryResult& result) const {
  // Where the radar has seen nothing of its submap for long, the submap goes on at the prediction:
  // waiting for the old one would be forever.
  const bool is_lost = result.status == OdometryResult::Status::kPredicted &&
                       result.num_gaussians >= options_.registration.min_gaussians &&
                       motion_.time_since_registered() > options_.motion.restart_time;
  if (result.status != OdometryResult::Status::kRegistered && !is_lost) return false;
  if (!T_world_keyframe_) return true;
  const Rigid3 T_keyframe_radar = T_world_keyframe_->Inverse() * result.T_world_radar;
  return T_keyframe_radar.translation.norm() > options_.submap.keyframe_distance ||
         RotationVector(T_keyframe_radar.rotation).norm() > options_.submap.keyframe_rotation;
}

void RadarOdometry::AddKeyframe(FilteredScan filtered, OdometryResult* result) {
  result->is_keyframe = true;
  T_world_keyframe_ = result->T_world_radar;
  result->keyframe_points.reserve(filtered.returns.size());
  for (const RadarReturn& radar_return : filtered.returns) {
    result->keyframe_points.push_back(result->T_world_radar * radar_return.position);
  }
  submap_->AddKeyframe({result->T_world_radar,
                        std::move(filtered.returns),
                        std::move(filtered.weights),
                        filtered.is_planar});
}

OdometryResult RadarOdometry::AddScan(const RadarScan& scan) {
  const Stopwatch stopwatch;
  OdometryResult result;
  result.index = num_scans_++;
  result.stamp_ns = scan.stamp_ns;
  result.num_returns = static_cast<int>(scan.returns.size());
  result.T_world_radar = motion_.T_world_radar();
  result.reason = WhyOutOfOrder(scan);
  if (!result.reason.empty()) {
    result.status = OdometryResult::Status::kSkipped;
    result.times_ms.total = stopwatch.Milliseconds();
    return result;
  }
  const double dt = last_stamp_ns_ ? Seconds(scan.stamp_ns - *last_stamp_ns_) : 0.0;

  const Stopwatch handover_stopwatch;
  submap_->NextScan();
  result.times_ms.submap = handover_stopwatch.Milliseconds();
  for (std::string& note : submap_->TakeNotes()) notes_.push_back(std::move(note));
  motion_.Advance(dt);
  NoteMissingDoppler(scan);
  FilteredScan filtered = filter_.Filter(scan, &result);
  Locate(scan, filtered, dt, &result);
  motion_.Follow(result, dt);
  last_stamp_ns_ = scan.stamp_ns;

  const Stopwatch submap_stopwatch;
  if (IsKeyframe(result)) AddKeyframe(std::move(filtered), &result);
  result.times_ms.submap += submap_stopwatch.Milliseconds();
  result.times_ms.total = stopwatch.Milliseconds();
  return result;
}

}  // namespace radive
