// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/odometry.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "radive/ndt/gaussian_builder.h"
#include "radive/odometry/scan_filter.h"
#include "radive/odometry/submap.h"
#include "radive/odometry/vehicle_model.h"
#include "radive/registration/ndt_registration.h"
#include "radive/util/stopwatch.h"

namespace radive {
namespace {

constexpr double kSecondsPerNanosecond = 1e-9;

// How much worse a prediction gets with the time that no scan was seen, beyond what the velocity's
// covariance says: the velocity and the turning rate change meanwhile.
constexpr double kUnseenAcceleration = 0.15;  // share of t^2 in the position [m/s^2]
constexpr double kUnseenRotationRate = 0.1;   // [rad/s]

// Standard deviation of a velocity that is carried over from the last registered motion, for want
// of Doppler [m/s].
constexpr double kUnknownVelocity = 1.0;

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
  explicit Impl(const OdometryOptions& options) : options_(options), submap_(MakeSubmap(options)) {
    std::string error;
    CHECK(options.IsValid(&error)) << error;
  }

  OdometryResult AddScan(const RadarScan& scan);

  std::vector<std::string> notes_;

 private:
  // Where the radar should be, before the scan is looked at.
  struct Prediction {
    Rigid3 T_world_radar;
    Eigen::Vector3d v_mean = Eigen::Vector3d::Zero();  // radar frame half-way [m/s]
    bool has_doppler = false;                          // v_mean is from the ego velocity
  };

  void NoteMissingDoppler(const RadarScan& scan);
  // Time up to now in which no scan was seen, beyond the usual interval [s].
  double UnseenTime(double dt) const {
    return usual_interval_ > 0.0 ? std::max(0.0, dt - usual_interval_) : 0.0;
  }
  // Standard deviation of what the motion did in that time [m].
  double UnseenSigma(double dt) const {
    return kUnseenAcceleration * UnseenTime(dt) * UnseenTime(dt);
  }
  Prediction Predict(const EgoVelocity& velocity, double dt) const;
  RegistrationPriors Priors(const Prediction& prediction,
                            const EgoVelocity& velocity,
                            const RadarScan& scan,
                            double dt) const;
  void Register(const RadarScan& scan,
                const FilteredScan& filtered,
                const Prediction& prediction,
                double dt,
                OdometryResult* result);
  Matrix6d PredictedCovariance(const EgoVelocity& velocity, double dt) const;
  bool IsKeyframe(const OdometryResult& result) const;
  void AddKeyframe(FilteredScan filtered, OdometryResult* result);

  const OdometryOptions options_;
  // For the radar that the first scan names.
  std::optional<VehicleModel> vehicle_;
  std::optional<ScanFilter> filter_;
  std::unique_ptr<Submap> submap_;

  int num_scans_ = 0;
  std::int64_t last_stamp_ns_ = 0;
  Rigid3 T_world_radar_;                                     // of the last scan
  Eigen::Vector3d last_velocity_ = Eigen::Vector3d::Zero();  // radar frame [m/s]
  Eigen::Vector3d last_rate_ = Eigen::Vector3d::Zero();      // radar frame [rad/s]
  bool has_doppler_velocity_ = false;                        // last_velocity_ is measured
  Matrix6d covariance_ = Matrix6d::Zero();                   // of the last pose
  double time_since_registered_ = 0.0;                       // [s]
  double usual_interval_ = 0.0;                              // between scans [s]
  std::optional<Rigid3> T_world_keyframe_;                   // the last keyframe
  bool has_noted_doppler_ = false;
};

void Odometry::Impl::NoteMissingDoppler(const RadarScan& scan) {
  if (has_noted_doppler_ || (scan.has_doppler && options_.ego_velocity.enabled)) return;
  has_noted_doppler_ = true;
  notes_.push_back(scan.has_doppler
                       ? "ego velocity is switched off: no dynamic filter, no weights"
                       : "scans carry no Doppler: ego velocity, dynamic filter and weights are "
                         "off");
}

Odometry::Impl::Prediction Odometry::Impl::Predict(const EgoVelocity& velocity, double dt) const {
  Prediction prediction;
  prediction.v_mean = last_velocity_;
  prediction.has_doppler = HasVelocity(velocity);
  if (prediction.has_doppler) {
    // Trapezoid: the mean of both ends, each in its own radar frame, belongs to the frame half-way.
    prediction.v_mean = has_doppler_velocity_
                            ? Eigen::Vector3d(0.5 * (last_velocity_ + velocity.v_radar))
                            : velocity.v_radar;
  }
  Eigen::Vector3d rate = last_rate_;
  if (const auto yaw_rate =
          prediction.has_doppler ? vehicle_->YawRate(prediction.v_mean) : std::nullopt) {
    const Eigen::Vector3d up = vehicle_->UpRadar();
    rate += up * (*yaw_rate - up.dot(rate));
  }
  const Eigen::Quaterniond half_turn = QuaternionFromRotationVector(0.5 * dt * rate);
  prediction.T_world_radar = {T_world_radar_.rotation * QuaternionFromRotationVector(dt * rate),
                              T_world_radar_.translation +
                                  T_world_radar_.rotation * (half_turn * (prediction.v_mean * dt))};
  return prediction;
}

RegistrationPriors Odometry::Impl::Priors(const Prediction& prediction,
                                          const EgoVelocity& velocity,
                                          const RadarScan& scan,
                                          double dt) const {
  const MotionOptions& motion = options_.motion;
  RegistrationPriors priors;
  if (prediction.has_doppler && motion.doppler_prior) {
    const double floor = motion.doppler_floor;
    const double variance = dt * dt * floor * floor + UnseenSigma(dt) * UnseenSigma(dt);
    priors.displacement = RegistrationPriors::Displacement{
        T_world_radar_,
        prediction.v_mean * dt,
        dt * dt * velocity.covariance + variance * Eigen::Matrix3d::Identity()};
  }
  if (motion.low_speed_lambda > 0.0 && prediction.has_doppler &&
      prediction.v_mean.norm() < motion.low_speed_limit) {
    priors.translation =
        RegistrationPriors::Translation{prediction.T_world_radar.translation,
                                        Eigen::Matrix3d::Identity() / motion.low_speed_lambda};
  }
  if (motion.rotation_sigma_rate > 0.0) {
    const double sigma = motion.rotation_sigma_rate * dt;
    priors.rotation = RegistrationPriors::Rotation{prediction.T_world_radar.rotation,
                                                   sigma * sigma * Eigen::Matrix3d::Identity()};
  }
  // The first radar frame is the world: the vehicle's up axis is the same in both.
  const Eigen::Vector3d up = vehicle_->UpRadar();
  if (motion.attitude_sigma > 0.0 && motion.height_sigma > 0.0) {
    priors.attitude_height = RegistrationPriors::AttitudeHeight{
        up, up, T_world_radar_.translation, motion.attitude_sigma, motion.height_sigma};
  }
  priors.no_slip = vehicle_->Prior(T_world_radar_, prediction.v_mean, dt);
  if (priors.no_slip) priors.no_slip->sigma = std::hypot(priors.no_slip->sigma, UnseenSigma(dt));
  if (options_.registration.planar || scan.is_planar) priors.plane_normal = up;
  return priors;
}

void Odometry::Impl::Register(const RadarScan& scan,
                              const FilteredScan& filtered,
                              const Prediction& prediction,
                              double dt,
                              OdometryResult* result) {
  const Stopwatch stopwatch;
  std::vector<Gaussian3> gaussians;
  if (options_.ndt.representation == NdtOptions::Representation::kPoint) {
    gaussians = GaussiansOfReturns(
        filtered.returns, filtered.weights, options_.sensor, options_.ndt, scan.is_planar);
  } else {
    std::vector<Eigen::Vector3d> points;
    points.reserve(filtered.returns.size());
    for (const RadarReturn& radar_return : filtered.returns) {
      points.push_back(radar_return.position);
    }
    gaussians = GaussiansOfVoxels(points, filtered.weights, options_.ndt);
  }
  result->num_gaussians = static_cast<int>(gaussians.size());
  const double gap = std::max(0.0, time_since_registered_ + dt - usual_interval_);
  const double growth = options_.motion.gap_slack_rate * gap;
  const double slack = options_.pairs.slack + growth;
  RegistrationOptions registration_options = options_.registration;
  registration_options.max_correction += growth;
  registration_options.max_rotation_correction += kUnseenRotationRate * gap;
  const RegistrationResult registration =
      RegisterNdt(gaussians,
                  *submap_->search(),
                  prediction.T_world_radar,
                  slack,
                  Priors(prediction, result->ego_velocity, scan, dt),
                  options_.pairs,
                  registration_options);
  result->num_pairs = registration.num_pairs;
  result->num_iterations = registration.num_iterations;
  result->cost = registration.cost;
  result->degenerate = registration.degenerate();
  result->covariance = registration.covariance;
  result->T_world_radar = registration.T_submap_radar;
  result->status = registration.converged ? OdometryResult::Status::kRegistered
                                          : OdometryResult::Status::kPredicted;
  result->reason = registration.message;
  if (registration.converged && UnseenTime(dt) < usual_interval_) {
    vehicle_->Update(
        prediction.v_mean, dt, registration.lateral_residual, registration.lateral_variance);
  }
  result->times_ms.pair_search = registration.pair_search_ms;
  result->times_ms.registration = stopwatch.Milliseconds() - registration.pair_search_ms;
}

// Of a pose that only the prediction moved: the last one's, and what the motion since adds.
Matrix6d Odometry::Impl::PredictedCovariance(const EgoVelocity& velocity, double dt) const {
  Matrix6d covariance = covariance_;
  const double sigma_rotation = kUnseenRotationRate * dt;
  covariance.topLeftCorner<3, 3>().diagonal().array() += sigma_rotation * sigma_rotation;
  const Eigen::Matrix3d R = T_world_radar_.RotationMatrix();
  const Eigen::Matrix3d velocity_covariance =
      HasVelocity(velocity)
          ? velocity.covariance
          : Eigen::Matrix3d(kUnknownVelocity * kUnknownVelocity * Eigen::Matrix3d::Identity());
  covariance.bottomRightCorner<3, 3>() += dt * dt * R * velocity_covariance * R.transpose();
  return covariance;
}

bool Odometry::Impl::IsKeyframe(const OdometryResult& result) const {
  // Where nothing of the submap is in view for long, it goes on at the prediction: waiting for the
  // old part would be forever.
  const bool is_lost = result.status == OdometryResult::Status::kPredicted &&
                       result.num_gaussians >= options_.registration.min_gaussians &&
                       time_since_registered_ > options_.motion.restart_time;
  if (result.status != OdometryResult::Status::kRegistered && !is_lost) return false;
  if (!T_world_keyframe_) return true;
  const Rigid3 T_keyframe_radar = T_world_keyframe_->Inverse() * result.T_world_radar;
  return T_keyframe_radar.translation.norm() > options_.submap.keyframe_distance ||
         RotationVector(T_keyframe_radar.rotation).norm() > options_.submap.keyframe_rotation;
}

void Odometry::Impl::AddKeyframe(FilteredScan filtered, OdometryResult* result) {
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

OdometryResult Odometry::Impl::AddScan(const RadarScan& scan) {
  const Stopwatch stopwatch;
  OdometryResult result;
  result.index = num_scans_++;
  result.stamp_ns = scan.stamp_ns;
  result.num_returns = static_cast<int>(scan.returns.size());
  result.T_world_radar = T_world_radar_;
  const bool is_first = result.index == 0;
  if (is_first) {
    const SensorOptions sensor = options_.sensor.ForRadar(scan.radar);
    vehicle_.emplace(options_.motion, sensor.T_vehicle_radar());
    filter_.emplace(options_, sensor);
  }
  if (!is_first && scan.stamp_ns <= last_stamp_ns_) {
    result.status = OdometryResult::Status::kSkipped;
    result.reason = scan.stamp_ns == last_stamp_ns_ ? "stamp repeats" : "stamp goes back";
    result.times_ms.total = stopwatch.Milliseconds();
    return result;
  }
  const double dt =
      is_first ? 0.0 : static_cast<double>(scan.stamp_ns - last_stamp_ns_) * kSecondsPerNanosecond;

  const Stopwatch handover_stopwatch;
  submap_->NextScan();
  result.times_ms.submap = handover_stopwatch.Milliseconds();
  for (std::string& note : submap_->TakeNotes()) notes_.push_back(std::move(note));
  vehicle_->Advance(dt);
  NoteMissingDoppler(scan);
  FilteredScan filtered = filter_->Filter(scan, &result);
  const EgoVelocity& velocity = result.ego_velocity;
  const Prediction prediction = Predict(velocity, dt);
  // What stands now may have moved since the last pose, when that is some scans ago.
  const bool may_have_moved = usual_interval_ > 0.0 &&
                              time_since_registered_ + dt > 1.5 * usual_interval_ &&
                              last_velocity_.norm() >= options_.ego_velocity.standing_speed;
  const bool is_standing = velocity.is_standing && !may_have_moved;
  if (submap_->search() == nullptr) {
    // Nothing to register against yet: the first scan with enough returns starts the submap.
    result.T_world_radar = prediction.T_world_radar;
    const bool can_start =
        static_cast<int>(filtered.returns.size()) >= options_.registration.min_gaussians;
    result.status =
        can_start ? OdometryResult::Status::kRegistered : OdometryResult::Status::kPredicted;
    if (!can_start) {
      result.reason = std::to_string(filtered.returns.size()) + " returns left, " +
                      std::to_string(options_.registration.min_gaussians) + " needed";
    }
  } else if (is_standing) {
    result.status = OdometryResult::Status::kStanding;
    result.reason = "standing";
  } else {
    Register(scan, filtered, prediction, dt, &result);
  }
  if (result.status == OdometryResult::Status::kPredicted && !velocity.valid && scan.has_doppler &&
      options_.ego_velocity.enabled && !velocity.reason.empty()) {
    result.reason = "ego velocity: " + velocity.reason;
  }

  if (result.status == OdometryResult::Status::kPredicted) {
    result.covariance = PredictedCovariance(velocity, dt);
  } else if (result.status == OdometryResult::Status::kStanding) {
    result.covariance = covariance_;
  }
  covariance_ = result.covariance;

  // Motion for the next prediction.
  if (dt > 0.0) {
    const Rigid3 T_last_now = T_world_radar_.Inverse() * result.T_world_radar;
    last_rate_ = RotationVector(T_last_now.rotation) / dt;
    if (!HasVelocity(velocity)) {
      const Eigen::Quaterniond half_back = QuaternionFromRotationVector(-0.5 * dt * last_rate_);
      last_velocity_ = half_back * T_last_now.translation / dt;
    }
    usual_interval_ = usual_interval_ == 0.0 ? dt : std::min(1.1 * usual_interval_, dt);
  }
  if (HasVelocity(velocity)) last_velocity_ = velocity.v_radar;
  has_doppler_velocity_ = HasVelocity(velocity);
  time_since_registered_ =
      result.status == OdometryResult::Status::kPredicted ? time_since_registered_ + dt : 0.0;
  T_world_radar_ = result.T_world_radar;
  last_stamp_ns_ = scan.stamp_ns;

  const Stopwatch submap_stopwatch;
  if (IsKeyframe(result)) AddKeyframe(std::move(filtered), &result);
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
