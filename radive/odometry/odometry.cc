// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/odometry.h"

#include <glog/logging.h>
#include <tsl/robin_map.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "radive/ego_velocity/ego_velocity_estimator.h"
#include "radive/ego_velocity/velocity_discrepancy.h"
#include "radive/ndt/gaussian_builder.h"
#include "radive/odometry/submap.h"
#include "radive/preprocessing/azimuth_bin_filter.h"
#include "radive/preprocessing/preprocess.h"
#include "radive/registration/ndt_registration.h"
#include "radive/util/cell_key.h"
#include "radive/util/stopwatch.h"

namespace radive {
namespace {

constexpr double kSecondsPerNanosecond = 1e-9;

// How much worse a prediction gets with the time that no scan was seen, beyond what the velocity's
// covariance says: the velocity and the turning rate change meanwhile.
constexpr double kUnseenAcceleration = 0.15;  // share of t^2 in the position [m/s^2]
constexpr double kUnseenRotationRate = 0.1;   // [rad/s]

// Shortest lever from which lateral Doppler velocity makes a turning rate [m].
constexpr double kMinLever = 1.0;

// Edge of the voxels that the map of a drive keeps one point of [m].
constexpr double kMapResolution = 0.25;

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
  explicit Impl(const OdometryOptions& options)
      : options_(options), submap_(MakeSubmap(options.submap, options.ndt, options.sensor)) {
    std::string error;
    CHECK(options.IsValid(&error)) << error;
  }

  OdometryResult AddScan(const RadarScan& scan);

  std::vector<Eigen::Vector3d> map_points_;
  std::vector<std::string> notes_;

 private:
  // The returns that registration works with.
  struct FilteredScan {
    std::vector<RadarReturn> returns;
    std::vector<double> weights;
  };

  // Where the radar should be, before the scan is looked at.
  struct Prediction {
    Rigid3 T_world_radar;
    std::optional<RegistrationPriors::Translation> doppler;  // from the ego velocity
    double speed = 0.0;                                      // [m/s]
  };

  FilteredScan Filter(const RadarScan& scan, OdometryResult* result);
  // Time up to now in which no scan was seen, beyond the usual interval [s].
  double UnseenTime(double dt) const {
    return usual_interval_ > 0.0 ? std::max(0.0, dt - usual_interval_) : 0.0;
  }
  Eigen::Vector3d MeanRate(const EgoVelocity& velocity, double dt) const;
  Prediction Predict(const EgoVelocity& velocity, double dt) const;
  RegistrationPriors Priors(const Prediction& prediction, const RadarScan& scan, double dt) const;
  void Register(const RadarScan& scan,
                const FilteredScan& filtered,
                const Prediction& prediction,
                double dt,
                OdometryResult* result);
  bool IsKeyframe(const Rigid3& T_world_radar) const;
  void AddKeyframe(const Rigid3& T_world_radar, FilteredScan filtered);
  Eigen::Vector3d UpRadar() const {
    return T_vehicle_radar_.rotation.conjugate() * Eigen::Vector3d::UnitZ();
  }

  const OdometryOptions options_;
  Rigid3 T_vehicle_radar_;  // of the radar that the first scan names
  std::optional<EgoVelocityEstimator> ego_velocity_;
  std::unique_ptr<Submap> submap_;
  tsl::robin_map<std::uint64_t, bool, CellKeyHash> map_cells_;

  int num_scans_ = 0;
  std::int64_t last_stamp_ns_ = 0;
  Rigid3 T_world_radar_;                                     // of the last scan
  Eigen::Vector3d last_velocity_ = Eigen::Vector3d::Zero();  // radar frame [m/s]
  Eigen::Vector3d last_rate_ = Eigen::Vector3d::Zero();      // radar frame [rad/s]
  bool has_doppler_velocity_ = false;                        // last_velocity_ is measured
  double time_since_registered_ = 0.0;                       // [s]
  double usual_interval_ = 0.0;                              // between scans [s]
  std::optional<Rigid3> T_world_keyframe_;                   // the last keyframe
  bool has_noted_doppler_ = false;
};

Odometry::Impl::FilteredScan Odometry::Impl::Filter(const RadarScan& scan, OdometryResult* result) {
  Stopwatch stopwatch;
  FilteredScan filtered;
  filtered.returns = CorrectAndGate(scan, options_.sensor, options_.preprocessing, nullptr);
  result->times_ms.preprocessing = stopwatch.Lap();

  const bool use_doppler = scan.has_doppler && options_.ego_velocity.enabled;
  if (use_doppler) {
    result->ego_velocity = ego_velocity_->Estimate(filtered.returns, scan.is_planar, scan.stamp_ns);
    if (result->ego_velocity.valid) {
      const std::vector<bool> keep =
          KeepMask(filtered.returns, result->ego_velocity.v_radar, options_.ego_velocity.keep_gate);
      std::size_t kept = 0;
      for (std::size_t i = 0; i < keep.size(); ++i) {
        if (keep[i]) filtered.returns[kept++] = filtered.returns[i];
      }
      filtered.returns.resize(kept);
    } else {
      // Without a velocity nothing tells static returns from moving ones.
      filtered.returns.clear();
    }
  } else if (!has_noted_doppler_) {
    has_noted_doppler_ = true;
    notes_.push_back(scan.has_doppler
                         ? "ego velocity is switched off: no dynamic filter, no weights"
                         : "scans carry no Doppler: ego velocity, dynamic filter and weights are "
                           "off");
  }
  result->times_ms.ego_velocity = stopwatch.Lap();
  filtered.returns = FilterAzimuthBins(filtered.returns, options_.preprocessing);
  filtered.weights = use_doppler && options_.ego_velocity.weights
                         ? DiscrepancyWeights(filtered.returns,
                                              result->ego_velocity.v_radar,
                                              options_.ego_velocity.discrepancy_scale)
                         : std::vector<double>(filtered.returns.size(), 1.0);
  result->num_kept = static_cast<int>(filtered.returns.size());
  result->times_ms.preprocessing += stopwatch.Lap();
  return filtered;
}

// Turning rate since the last scan, radar frame [rad/s]: the last one, and over an outage, in which
// it would grow stale, the mean of what the lateral Doppler velocity of a road vehicle says of both
// ends. The rate between two scans is noisy, and an outage multiplies it by many scans.
Eigen::Vector3d Odometry::Impl::MeanRate(const EgoVelocity& velocity, double dt) const {
  const double lever = T_vehicle_radar_.translation.x();
  if (!(UnseenTime(dt) > 2.0 * usual_interval_) || !velocity.valid || !has_doppler_velocity_ ||
      !options_.motion.no_slip || std::abs(lever) < kMinLever) {
    return last_rate_;
  }
  const Eigen::Vector3d v_mean = 0.5 * (last_velocity_ + velocity.v_radar);
  const double yaw_rate = (T_vehicle_radar_.rotation * v_mean).y() / lever;
  return T_vehicle_radar_.rotation.conjugate() * Eigen::Vector3d(0.0, 0.0, yaw_rate);
}

Odometry::Impl::Prediction Odometry::Impl::Predict(const EgoVelocity& velocity, double dt) const {
  Prediction prediction;
  const Eigen::Vector3d rate = MeanRate(velocity, dt);
  const Eigen::Quaterniond turn = QuaternionFromRotationVector(rate * dt);
  const Eigen::Quaterniond half_turn = QuaternionFromRotationVector(0.5 * dt * rate);
  Eigen::Vector3d v_mean = last_velocity_;
  if (velocity.valid) {
    // Trapezoid: the mean of both ends, each in its own radar frame, is the chord half-way.
    v_mean = has_doppler_velocity_ ? Eigen::Vector3d(0.5 * (last_velocity_ + velocity.v_radar))
                                   : velocity.v_radar;
  }
  prediction.speed = v_mean.norm();
  const Eigen::Quaterniond q_world_middle = T_world_radar_.rotation * half_turn;
  prediction.T_world_radar = {T_world_radar_.rotation * turn,
                              T_world_radar_.translation + q_world_middle * (v_mean * dt)};
  if (velocity.valid) {
    const Eigen::Matrix3d R = q_world_middle.toRotationMatrix();
    const double floor = options_.motion.doppler_floor;
    const Eigen::Matrix3d covariance =
        velocity.covariance + floor * floor * Eigen::Matrix3d::Identity();
    const double unseen = UnseenTime(dt);
    const double sigma_unseen = kUnseenAcceleration * unseen * unseen;
    prediction.doppler = RegistrationPriors::Translation{
        prediction.T_world_radar.translation,
        dt * dt * R * covariance * R.transpose() +
            sigma_unseen * sigma_unseen * Eigen::Matrix3d::Identity()};
  }
  return prediction;
}

RegistrationPriors Odometry::Impl::Priors(const Prediction& prediction,
                                          const RadarScan& scan,
                                          double dt) const {
  const MotionOptions& motion = options_.motion;
  RegistrationPriors priors;
  if (prediction.doppler && motion.doppler_prior) {
    priors.translations.push_back(*prediction.doppler);
  }
  if (motion.low_speed_lambda > 0.0 && prediction.doppler &&
      prediction.speed < motion.low_speed_limit) {
    priors.translations.push_back({prediction.T_world_radar.translation,
                                   Eigen::Matrix3d::Identity() / motion.low_speed_lambda});
  }
  if (motion.rotation_sigma_rate > 0.0) {
    const double sigma = motion.rotation_sigma_rate * dt;
    priors.rotation = RegistrationPriors::Rotation{prediction.T_world_radar.rotation,
                                                   sigma * sigma * Eigen::Matrix3d::Identity()};
  }
  // The first radar frame is the world: the vehicle's up axis is the same in both.
  if (motion.attitude_sigma > 0.0 && motion.height_sigma > 0.0) {
    priors.attitude_height = RegistrationPriors::AttitudeHeight{UpRadar(),
                                                                UpRadar(),
                                                                T_world_radar_.translation,
                                                                motion.attitude_sigma,
                                                                motion.height_sigma};
  }
  if (motion.no_slip) {
    RegistrationPriors::NoSlip prior;
    prior.T_submap_radar0 = T_world_radar_;
    prior.T_e_radar = T_vehicle_radar_;
    const double distance = prediction.speed * dt;
    // The point without slip lies ahead of the rear axle by compliance * v^2.
    prior.T_e_radar.translation.x() -= motion.slip_compliance * prediction.speed * prediction.speed;
    prior.lateral_offset = 0.0;
    const double unseen = UnseenTime(dt);
    prior.sigma = motion.no_slip_floor + motion.no_slip_ratio * distance +
                  kUnseenAcceleration * unseen * unseen;
    priors.no_slip = prior;
  }
  if (options_.registration.planar || scan.is_planar) priors.plane_normal = UpRadar();
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
    gaussians =
        GaussiansOfReturns(filtered.returns, filtered.weights, options_.sensor, options_.ndt);
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
  const RegistrationResult registration = RegisterNdt(gaussians,
                                                      *submap_->search(),
                                                      prediction.T_world_radar,
                                                      slack,
                                                      Priors(prediction, scan, dt),
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
  result->times_ms.pair_search = registration.pair_search_ms;
  result->times_ms.registration = stopwatch.Milliseconds() - registration.pair_search_ms;
}

bool Odometry::Impl::IsKeyframe(const Rigid3& T_world_radar) const {
  if (!T_world_keyframe_) return true;
  const Rigid3 T_keyframe_radar = T_world_keyframe_->Inverse() * T_world_radar;
  return T_keyframe_radar.translation.norm() > options_.submap.keyframe_distance ||
         RotationVector(T_keyframe_radar.rotation).norm() > options_.submap.keyframe_rotation;
}

void Odometry::Impl::AddKeyframe(const Rigid3& T_world_radar, FilteredScan filtered) {
  T_world_keyframe_ = T_world_radar;
  for (const RadarReturn& radar_return : filtered.returns) {
    const Eigen::Vector3d p = T_world_radar * radar_return.position;
    const Eigen::Vector3d cell = (p / kMapResolution).array().floor();
    if (map_cells_.try_emplace(CellKey(cell.x(), cell.y(), cell.z()), true).second) {
      map_points_.push_back(p);
    }
  }
  submap_->AddKeyframe({T_world_radar, std::move(filtered.returns), std::move(filtered.weights)});
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
    T_vehicle_radar_ = sensor.T_vehicle_radar();
    ego_velocity_.emplace(options_.ego_velocity, sensor);
  }
  if (!is_first && scan.stamp_ns <= last_stamp_ns_) {
    result.status = OdometryResult::Status::kSkipped;
    result.reason = scan.stamp_ns == last_stamp_ns_ ? "stamp repeats" : "stamp goes back";
    result.times_ms.total = stopwatch.Milliseconds();
    return result;
  }
  const double dt =
      is_first ? 0.0 : static_cast<double>(scan.stamp_ns - last_stamp_ns_) * kSecondsPerNanosecond;

  FilteredScan filtered = Filter(scan, &result);
  const EgoVelocity& velocity = result.ego_velocity;
  const Prediction prediction = Predict(velocity, dt);
  // What stands now may have moved since the last pose, when that is some scans ago.
  const bool may_have_moved = usual_interval_ > 0.0 &&
                              time_since_registered_ + dt > 1.5 * usual_interval_ &&
                              last_velocity_.norm() >= options_.ego_velocity.standing_speed;
  const bool is_standing = !may_have_moved && velocity.valid &&
                           velocity.v_radar.norm() < options_.ego_velocity.standing_speed;
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

  // Motion for the next prediction.
  if (dt > 0.0) {
    const Rigid3 T_last_now = T_world_radar_.Inverse() * result.T_world_radar;
    last_rate_ = RotationVector(T_last_now.rotation) / dt;
    if (!velocity.valid) {
      const Eigen::Quaterniond half_back = QuaternionFromRotationVector(-0.5 * dt * last_rate_);
      last_velocity_ = half_back * T_last_now.translation / dt;
    }
    usual_interval_ = usual_interval_ == 0.0 ? dt : std::min(1.1 * usual_interval_, dt);
  }
  if (velocity.valid) last_velocity_ = velocity.v_radar;
  has_doppler_velocity_ = velocity.valid;
  time_since_registered_ =
      result.status == OdometryResult::Status::kPredicted ? time_since_registered_ + dt : 0.0;
  T_world_radar_ = result.T_world_radar;
  last_stamp_ns_ = scan.stamp_ns;

  const Stopwatch submap_stopwatch;
  if (result.status == OdometryResult::Status::kRegistered && IsKeyframe(T_world_radar_)) {
    result.is_keyframe = true;
    AddKeyframe(T_world_radar_, std::move(filtered));
  }
  result.times_ms.submap = submap_stopwatch.Milliseconds();
  result.times_ms.total = stopwatch.Milliseconds();
  return result;
}

Odometry::Odometry(const OdometryOptions& options) : impl_(std::make_unique<Impl>(options)) {}
Odometry::~Odometry() = default;
Odometry::Odometry(Odometry&&) noexcept = default;
Odometry& Odometry::operator=(Odometry&&) noexcept = default;

OdometryResult Odometry::AddScan(const RadarScan& scan) { return impl_->AddScan(scan); }
std::vector<Eigen::Vector3d> Odometry::MapPoints() const { return impl_->map_points_; }
std::vector<std::string> Odometry::TakeNotes() { return std::exchange(impl_->notes_, {}); }

}  // namespace radive
