// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/radar_odometry.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "radive/ndt/choose_representation.h"
#include "radive/odometry/scan_filter.h"
#include "radive/odometry/submap.h"
#include "radive/registration/registration.h"
#include "radive/util/number_text.h"
#include "radive/util/seconds.h"
#include "radive/util/stopwatch.h"

namespace radive {
namespace {

// A gap that is worth a warning: so many usual intervals, and so long [s].
constexpr double kGapIntervals = 5.0;
constexpr double kGapTime = 1.0;
// A scan behind a gap fits as scans before did with this share of their pairs at least, and a cost
// that is higher by this share at most.
constexpr double kFewerPairs = 0.8;
constexpr double kHigherCost = 0.3;

}  // namespace

RadarOdometry::RadarOdometry(const OdometryOptions& options)
    : options_(options),
      motion_(options),
      gate_(options.motion.innovation_gate),
      filter_(options, options.sensor) {}

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

bool RadarOdometry::CanStart(const FilteredScan& filtered) const {
  return static_cast<int>(filtered.returns.size()) >= options_.registration.min_gaussians;
}

void RadarOdometry::PrepareSubmap(const FilteredScan& filtered) {
  if (submap_ != nullptr || !CanStart(filtered)) return;
  if (options_.ndt.representation == NdtOptions::Representation::kAuto) {
    std::string reason;
    options_.ndt.representation = ChooseRepresentation(filtered.returns, options_.ndt, &reason);
    notes_.push_back(std::move(reason));
  }
  submap_ = MakeSubmap(options_);
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

bool RadarOdometry::CheckInnovation(const MotionPrediction& prediction,
                                    double dt,
                                    OdometryResult* result) {
  if (result->status != OdometryResult::Status::kRegistered) {
    gate_.Forget();
    return false;
  }
  const double usual_interval = motion_.usual_interval();
  const double num_intervals = usual_interval > 0.0 ? dt / usual_interval : 1.0;
  result->reason = gate_.Check(
      motion_.T_world_radar(), prediction.T_world_radar, result->T_world_radar, num_intervals);
  if (!result->reason.empty()) {
    result->status = OdometryResult::Status::kPredicted;
    result->T_world_radar = prediction.T_world_radar;
    return true;
  }
  if (gate_.T_world_corrected()) motion_.MoveTo(*gate_.T_world_corrected());
  return false;
}

void RadarOdometry::LocateBehindGap(const FilteredScan& filtered,
                                    double dt,
                                    OdometryResult* result) {
  const double interval = motion_.usual_interval();
  Register(filtered, motion_.Predict(result->ego_velocity, interval), interval, result);
  const double num_gaussians = std::max(1, result->num_gaussians);
  // Costs of NDT are below 0: the more, the better.
  const double worst_cost = usual_cost_ + kHigherCost * std::abs(usual_cost_);
  const bool fits = result->status == OdometryResult::Status::kRegistered &&
                    result->num_pairs >= kFewerPairs * usual_pairs_ * num_gaussians &&
                    (!has_fit_ || result->cost <= worst_cost * num_gaussians);
  if (fits) return;
  result->status = OdometryResult::Status::kPredicted;
  result->reason = "the motion during a gap without scans is unknown" +
                   (result->reason.empty() ? "" : ": " + result->reason);
  result->T_world_radar = motion_.Predict(result->ego_velocity, dt).T_world_radar;
  result->num_pairs = 0;
  result->cost = 0.0;
  if (submap_ != nullptr) submap_->Clear();
  T_world_keyframe_.reset();
}

void RadarOdometry::WarnOfGap(double dt, const OdometryResult& result) {
  const double usual_interval = motion_.usual_interval();
  if (usual_interval == 0.0 || dt <= std::max(kGapTime, kGapIntervals * usual_interval)) return;
  const std::string gap = FormatText(
      "gap of %.4g s without scans before the stamp %.3f: ", dt, Seconds(result.stamp_ns));
  std::string what = "the scan behind it is registered with the submap before";
  if (result.status == OdometryResult::Status::kStanding) what = "the radar stands at both ends";
  if (result.status == OdometryResult::Status::kPredicted) {
    what = "the scan behind it does not fit the submap before; the pose rests on the velocities";
  }
  if (motion_.UnknownTime(dt) > 0.0) {
    what = result.status == OdometryResult::Status::kRegistered
               ? "the scan behind it fits as if no time had passed, and is taken so"
               : "the motion within is unknown beyond " +
                     std::to_string(static_cast<int>(kCarriedTime)) +
                     " s of the velocities at its ends; the map starts anew";
  }
  warnings_.push_back(gap + what);
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
  bool is_refused = false;
  const bool may_have_moved = usual_interval > 0.0 &&
                              motion_.time_since_registered() + dt > 1.5 * usual_interval &&
                              motion_.speed() >= options_.ego_velocity.standing_speed;
  if (submap_ == nullptr || submap_->search() == nullptr) {
    // Nothing to register against yet: the first scan with enough returns starts the submap.
    result->T_world_radar = prediction.T_world_radar;
    result->covariance = motion_.covariance();
    const bool can_start = CanStart(filtered);
    result->status =
        can_start ? OdometryResult::Status::kRegistered : OdometryResult::Status::kPredicted;
    if (!can_start) {
      result->reason = std::to_string(filtered.returns.size()) + " returns left, " +
                       std::to_string(options_.registration.min_gaussians) + " needed";
    }
  } else if (motion_.UnknownTime(dt) > 0.0) {
    LocateBehindGap(filtered, dt, result);
  } else if (velocity.is_standing && !may_have_moved) {
    result->status = OdometryResult::Status::kStanding;
    result->reason = "standing";
    result->T_world_radar = motion_.T_world_radar();
    result->covariance = motion_.covariance();
  } else {
    Register(filtered, prediction, dt, result);
    is_refused = CheckInnovation(prediction, dt, result);
  }
  if (result->status != OdometryResult::Status::kPredicted) return;
  result->covariance = motion_.PredictedCovariance(velocity, dt);
  if (!velocity.valid && scan.has_doppler && options_.ego_velocity.enabled &&
      !velocity.reason.empty() && motion_.UnknownTime(dt) == 0.0) {
    result->reason = "ego velocity: " + velocity.reason + (is_refused ? "; " + result->reason : "");
  }
  TellWhatIsDropped(result);
}

// What a scan with hardly any return left lacks is in its reason; this is where they went.
void RadarOdometry::TellWhatIsDropped(OdometryResult* result) const {
  const DropCounts& dropped = result->dropped;
  const int num_outside = dropped.not_finite + dropped.out_of_range + dropped.out_of_view;
  if (2 * num_outside <= result->num_returns) return;
  result->reason += FormatText("; of %d returns %d are outside %g to %g m, %d outside the view",
                               result->num_returns,
                               dropped.out_of_range,
                               options_.preprocessing.min_range,
                               options_.preprocessing.max_range,
                               dropped.out_of_view);
  if (dropped.not_finite > 0) {
    result->reason += FormatText(", and %d are no numbers", dropped.not_finite);
  }
}

void RadarOdometry::LearnFit(const OdometryResult& result) {
  const double num_gaussians = std::max(1, result.num_gaussians);
  const double gain = has_fit_ ? 0.3 : 1.0;
  has_fit_ = true;
  usual_pairs_ += gain * (result.num_pairs / num_gaussians - usual_pairs_);
  usual_cost_ += gain * (result.cost / num_gaussians - usual_cost_);
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
  if (submap_ != nullptr) {
    submap_->NextScan();
    for (std::string& note : submap_->TakeNotes()) notes_.push_back(std::move(note));
  }
  result.times_ms.submap = handover_stopwatch.Milliseconds();
  motion_.Advance(dt);
  NoteMissingDoppler(scan);
  FilteredScan filtered = filter_.Filter(scan, &result);
  PrepareSubmap(filtered);
  Locate(scan, filtered, dt, &result);
  WarnOfGap(dt, result);
  if (result.status == OdometryResult::Status::kRegistered && result.num_pairs > 0) {
    LearnFit(result);
  }
  motion_.Follow(result, dt);
  last_stamp_ns_ = scan.stamp_ns;

  const Stopwatch submap_stopwatch;
  if (IsKeyframe(result)) AddKeyframe(std::move(filtered), &result);
  result.times_ms.submap += submap_stopwatch.Milliseconds();
  result.times_ms.total = stopwatch.Milliseconds();
  return result;
}

}  // namespace radive
