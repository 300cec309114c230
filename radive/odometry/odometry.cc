// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/odometry.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "radive/odometry/scan_filter.h"
#include "radive/odometry/submap.h"
#include "radive/odometry/vehicle_model.h"
#include "radive/registration/ndt_registration.h"
#include "radive/util/stopwatch.h"

namespace radive {
namespace {

double Seconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

// Standard deviation of a predicted turning rate [rad/s].
constexpr double kPredictedRateSigma = 0.03;

// Two radars may measure at the same time; the noise of a motion in no time at all is not zero [s].
constexpr double kShortestInterval = 1e-3;

// How much worse a prediction gets with the time that no scan was seen, beyond what the velocity's
// covariance says: the velocity and the turning rate change meanwhile.
constexpr double kUnseenAcceleration = 0.15;  // share of t^2 in the position [m/s^2]
constexpr double kUnseenRotationRate = 0.1;   // [rad/s]

// Standard deviation of a velocity that is carried over from the last registered motion, for want
// of Doppler [m/s].
constexpr double kUnknownVelocity = 1.0;

// Covariance of the pose of a point that is rigidly joined to the one whose covariance is given, at
// `lever` from it [m] (world frame): its translation moves by dt + dr x lever.
Matrix6d CovarianceAtLever(const Matrix6d& covariance, const Eigen::Vector3d& lever) {
  Matrix6d jacobian = Matrix6d::Identity();
  jacobian.block<3, 3>(3, 0) << 0.0, lever.z(), -lever.y(),  //
      -lever.z(), 0.0, lever.x(),                            //
      lever.y(), -lever.x(), 0.0;
  return jacobian * covariance * jacobian.transpose();
}

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
  explicit Impl(const OdometryOptions& options) : options_(options), vehicle_(options.motion) {
    std::string error;
    CHECK(options.IsValid(&error)) << error;
  }

  OdometryResult AddScan(const RadarScan& scan);

  std::vector<std::string> notes_;

 private:
  // A radar of the vehicle, and what its last scan left.
  struct Radar {
    Radar(const OdometryOptions& options, const SensorOptions& sensor)
        : T_vehicle_radar(sensor.T_vehicle_radar()),
          filter(options, sensor),
          submap(MakeSubmap(options)) {}

    Rigid3 T_vehicle_radar;
    Rigid3 T_body_radar;
    ScanFilter filter;
    // Of its own keyframes: what two radars measure of the same wall differs by their azimuth
    // errors, and a scan drawn to the other's wall turns the vehicle.
    std::unique_ptr<Submap> submap;
    bool has_scan = false;
    std::int64_t stamp_ns = 0;                            // of its last scan
    Rigid3 T_world_body;                                  // then
    Eigen::Vector3d v_doppler = Eigen::Vector3d::Zero();  // then, in the radar frame [m/s]
    bool has_doppler_velocity = false;                    // v_doppler was measured
    double time_since_registered = 0.0;                   // [s]
    double usual_interval = 0.0;                          // between its scans [s]
    std::optional<Rigid3> T_world_keyframe;               // T_world_radar of its last keyframe
  };

  // Time up to a scan [s].
  struct Interval {
    double dt = 0.0;      // since the last scan of any radar
    double own_dt = 0.0;  // since the last scan of the same radar; 0: none
  };

  // Where the radar should be, before the scan is looked at.
  struct Prediction {
    Rigid3 T_world_radar;
    Eigen::Vector3d v_mean = Eigen::Vector3d::Zero();  // of the radar, in its frame half-way [m/s]
    bool has_doppler = false;                          // v_mean is from the ego velocity
    Eigen::Vector3d rate = Eigen::Vector3d::Zero();    // of turning, radar frame [rad/s]
  };

  Radar* RadarOf(const RadarScan& scan);
  // "stamp repeats" or "stamp goes back" when the scan cannot follow the last one.
  std::string WhyOutOfOrder(const RadarScan& scan, const Radar& radar) const;
  void NoteMissingDoppler(const RadarScan& scan);
  // Velocity of the radar [m/s] that goes with the body's, in the radar frame.
  Eigen::Vector3d LastVelocityOf(const Radar& radar) const {
    return radar.T_body_radar.rotation.conjugate() *
           (last_velocity_ + last_rate_.cross(radar.T_body_radar.translation));
  }
  // Time up to now in which no scan was seen, beyond the usual interval [s].
  static double UnseenTime(const Radar& radar, double dt) {
    return radar.usual_interval > 0.0 ? std::max(0.0, dt - radar.usual_interval) : 0.0;
  }
  // Standard deviation of what the motion did in that time [m].
  static double UnseenSigma(const Radar& radar, double dt) {
    return kUnseenAcceleration * UnseenTime(radar, dt) * UnseenTime(radar, dt);
  }
  Prediction Predict(const Radar& radar,
                     const EgoVelocity& velocity,
                     const Interval& interval) const;
  void MoveToCentre(const Radar& radar,
                    const Prediction& prediction,
                    double dt,
                    RegistrationPriors::Displacement* prior) const;
  RegistrationPriors Priors(const Radar& radar,
                            const Prediction& prediction,
                            const EgoVelocity& velocity,
                            bool is_planar,
                            double dt) const;
  void Locate(const Radar& radar,
              const RadarScan& scan,
              const FilteredScan& filtered,
              const Interval& interval,
              OdometryResult* result);
  void Register(const Radar& radar,
                const FilteredScan& filtered,
                const Prediction& prediction,
                double dt,
                OdometryResult* result);
  Matrix6d PredictedCovariance(const EgoVelocity& velocity, const Radar& radar, double dt) const;
  void FollowMotion(const OdometryResult& result, const Interval& interval, Radar* radar);
  bool IsKeyframe(const Radar& radar, const OdometryResult& result) const;
  void AddKeyframe(FilteredScan filtered, Radar* radar, OdometryResult* result);

  const OdometryOptions options_;
  VehicleModel vehicle_;
  std::map<int, Radar> radars_;  // by the number that scans give
  int first_radar_ = 0;

  // The body is what the trajectory is of: the vehicle, or the radar of the first scan.
  int num_scans_ = 0;
  std::int64_t last_stamp_ns_ = 0;
  Rigid3 T_world_body_;
  Eigen::Vector3d up_world_ = Eigen::Vector3d::UnitZ();      // the vehicle's up axis at the start
  Eigen::Vector3d last_velocity_ = Eigen::Vector3d::Zero();  // body frame [m/s]
  Eigen::Vector3d last_rate_ = Eigen::Vector3d::Zero();      // body frame [rad/s]
  Matrix6d covariance_ = Matrix6d::Zero();                   // of the last pose
  double time_since_registered_ = 0.0;                       // [s]
  bool has_noted_doppler_ = false;
};

Odometry::Impl::Radar* Odometry::Impl::RadarOf(const RadarScan& scan) {
  const auto known = radars_.find(scan.radar);
  if (known != radars_.end()) return &known->second;
  Radar radar(options_, options_.sensor.ForRadar(scan.radar));
  if (options_.motion.body == MotionOptions::Body::kVehicle) {
    radar.T_body_radar = radar.T_vehicle_radar;
  } else if (!radars_.empty()) {
    const Radar& first = radars_.at(first_radar_);
    radar.T_body_radar = first.T_vehicle_radar.Inverse() * radar.T_vehicle_radar;
  }
  if (radars_.empty()) {
    first_radar_ = scan.radar;
    up_world_ = radar.T_body_radar.rotation * UpRadar(radar.T_vehicle_radar);
  }
  return &radars_.emplace(scan.radar, std::move(radar)).first->second;
}

std::string Odometry::Impl::WhyOutOfOrder(const RadarScan& scan, const Radar& radar) const {
  if (num_scans_ == 0 || scan.stamp_ns > last_stamp_ns_) return "";
  if (scan.stamp_ns < last_stamp_ns_) return "stamp goes back";
  // Two radars may measure at the same time.
  return radar.has_scan && scan.stamp_ns == radar.stamp_ns ? "stamp repeats" : "";
}

void Odometry::Impl::NoteMissingDoppler(const RadarScan& scan) {
  if (has_noted_doppler_ || (scan.has_doppler && options_.ego_velocity.enabled)) return;
  has_noted_doppler_ = true;
  notes_.push_back(scan.has_doppler
                       ? "ego velocity is switched off: no dynamic filter, no weights"
                       : "scans carry no Doppler: ego velocity, dynamic filter and weights are "
                         "off");
}

Odometry::Impl::Prediction Odometry::Impl::Predict(const Radar& radar,
                                                   const EgoVelocity& velocity,
                                                   const Interval& interval) const {
  const double dt = interval.dt;
  Prediction prediction;
  prediction.has_doppler = HasVelocity(velocity);
  if (prediction.has_doppler && radar.has_doppler_velocity) {
    // Half-way through the last `dt`, linear in time since this radar's last scan. Each velocity is
    // in its own radar frame; what is between them belongs to the frame between.
    const double share_of_last = 0.5 * dt / interval.own_dt;
    prediction.v_mean = share_of_last * radar.v_doppler + (1.0 - share_of_last) * velocity.v_radar;
  } else {
    prediction.v_mean = prediction.has_doppler ? velocity.v_radar : LastVelocityOf(radar);
  }
  Eigen::Vector3d rate = last_rate_;
  if (const auto yaw_rate = prediction.has_doppler
                                ? vehicle_.YawRate(radar.T_vehicle_radar, prediction.v_mean)
                                : std::nullopt) {
    const Eigen::Vector3d up = radar.T_body_radar.rotation * UpRadar(radar.T_vehicle_radar);
    rate += up * (*yaw_rate - up.dot(rate));
  }
  prediction.rate = radar.T_body_radar.rotation.conjugate() * rate;
  const Eigen::Vector3d v_body =
      radar.T_body_radar.rotation * prediction.v_mean - rate.cross(radar.T_body_radar.translation);
  const Eigen::Quaterniond half_turn = QuaternionFromRotationVector(0.5 * dt * rate);
  const Rigid3 T_world_body = {
      T_world_body_.rotation * QuaternionFromRotationVector(dt * rate),
      T_world_body_.translation + T_world_body_.rotation * (half_turn * (v_body * dt))};
  prediction.T_world_radar = T_world_body * radar.T_body_radar;
  return prediction;
}

// States the displacement of the point amid the radars. Yaw that one radar corrects and the next
// takes back, for their maps never agree quite, would turn the body about each in turn, and so walk
// it sideways.
void Odometry::Impl::MoveToCentre(const Radar& radar,
                                  const Prediction& prediction,
                                  double dt,
                                  RegistrationPriors::Displacement* prior) const {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // body frame
  for (const auto& entry : radars_) centre += entry.second.T_body_radar.translation;
  centre /= static_cast<double>(radars_.size());
  prior->lever = radar.T_body_radar.Inverse() * centre;
  prior->displacement += prediction.rate.cross(prior->lever) * dt;
  const Eigen::Vector3d sideways =
      UpRadar(radar.T_vehicle_radar).cross(prior->lever) * kPredictedRateSigma * dt;
  prior->covariance += sideways * sideways.transpose();
}

RegistrationPriors Odometry::Impl::Priors(const Radar& radar,
                                          const Prediction& prediction,
                                          const EgoVelocity& velocity,
                                          bool is_planar,
                                          double dt) const {
  const MotionOptions& motion = options_.motion;
  const Rigid3 T_world_radar0 = T_world_body_ * radar.T_body_radar;
  RegistrationPriors priors;
  if (prediction.has_doppler && motion.doppler_prior) {
    const double time = std::max(dt, kShortestInterval);
    const double floor = motion.doppler_floor;
    const double unseen = UnseenSigma(radar, dt);
    const double variance = time * time * floor * floor + unseen * unseen;
    priors.displacement = RegistrationPriors::Displacement{
        T_world_radar0,
        prediction.v_mean * dt,
        time * time * velocity.covariance + variance * Eigen::Matrix3d::Identity()};
    if (radars_.size() > 1) MoveToCentre(radar, prediction, time, &*priors.displacement);
  }
  if (motion.low_speed_lambda > 0.0 && prediction.has_doppler &&
      prediction.v_mean.norm() < motion.low_speed_limit) {
    priors.translation =
        RegistrationPriors::Translation{prediction.T_world_radar.translation,
                                        Eigen::Matrix3d::Identity() / motion.low_speed_lambda};
  }
  if (motion.rotation_sigma_rate > 0.0) {
    const double sigma = motion.rotation_sigma_rate * std::max(dt, kShortestInterval);
    priors.rotation = RegistrationPriors::Rotation{prediction.T_world_radar.rotation,
                                                   sigma * sigma * Eigen::Matrix3d::Identity()};
  }
  if (motion.attitude_sigma > 0.0 && motion.height_sigma > 0.0) {
    priors.attitude_height = RegistrationPriors::AttitudeHeight{UpRadar(radar.T_vehicle_radar),
                                                                up_world_,
                                                                T_world_radar0.translation,
                                                                motion.attitude_sigma,
                                                                motion.height_sigma};
  }
  priors.no_slip = vehicle_.Prior(radar.T_vehicle_radar, T_world_radar0, prediction.v_mean, dt);
  if (priors.no_slip) {
    priors.no_slip->sigma = std::hypot(priors.no_slip->sigma, UnseenSigma(radar, dt));
  }
  if (options_.registration.planar || is_planar) priors.plane_normal = up_world_;
  return priors;
}

void Odometry::Impl::Register(const Radar& radar,
                              const FilteredScan& filtered,
                              const Prediction& prediction,
                              double dt,
                              OdometryResult* result) {
  const Stopwatch stopwatch;
  const std::vector<Gaussian3> gaussians = GaussiansOfScan(filtered, options_);
  result->num_gaussians = static_cast<int>(gaussians.size());
  const double gap = std::max(0.0, time_since_registered_ + dt - radar.usual_interval);
  const double growth = options_.motion.gap_slack_rate * gap;
  const double slack = options_.pairs.slack + growth;
  RegistrationOptions registration_options = options_.registration;
  registration_options.max_correction += growth;
  registration_options.max_rotation_correction += kUnseenRotationRate * gap;
  const RegistrationResult registration =
      RegisterNdt(gaussians,
                  *radar.submap->search(),
                  prediction.T_world_radar,
                  slack,
                  Priors(radar, prediction, result->ego_velocity, filtered.is_planar, dt),
                  options_.pairs,
                  registration_options);
  result->num_pairs = registration.num_pairs;
  result->num_iterations = registration.num_iterations;
  result->cost = registration.cost;
  result->degenerate = registration.degenerate();
  result->T_world_radar = registration.T_submap_radar;
  const Rigid3 T_radar_body = radar.T_body_radar.Inverse();
  result->covariance = CovarianceAtLever(registration.covariance,
                                         result->T_world_radar.rotation * T_radar_body.translation);
  result->status = registration.converged ? OdometryResult::Status::kRegistered
                                          : OdometryResult::Status::kPredicted;
  result->reason = registration.message;
  if (registration.converged && UnseenTime(radar, dt) < radar.usual_interval) {
    vehicle_.Update(radar.T_vehicle_radar,
                    prediction.v_mean,
                    dt,
                    registration.lateral_residual,
                    registration.lateral_variance);
  }
  result->times_ms.pair_search = registration.pair_search_ms;
  result->times_ms.registration = stopwatch.Milliseconds() - registration.pair_search_ms;
}

// Of a pose that only the prediction moved: the last one's, and what the motion since adds.
Matrix6d Odometry::Impl::PredictedCovariance(const EgoVelocity& velocity,
                                             const Radar& radar,
                                             double dt) const {
  Matrix6d covariance = covariance_;
  const double sigma_rotation = kUnseenRotationRate * dt;
  covariance.topLeftCorner<3, 3>().diagonal().array() += sigma_rotation * sigma_rotation;
  const Eigen::Matrix3d R = (T_world_body_ * radar.T_body_radar).RotationMatrix();
  const Eigen::Matrix3d velocity_covariance =
      HasVelocity(velocity)
          ? velocity.covariance
          : Eigen::Matrix3d(kUnknownVelocity * kUnknownVelocity * Eigen::Matrix3d::Identity());
  covariance.bottomRightCorner<3, 3>() += dt * dt * R * velocity_covariance * R.transpose();
  return covariance;
}

// The pose of the scan: status, reason, T_world_radar and covariance of `result`.
void Odometry::Impl::Locate(const Radar& radar,
                            const RadarScan& scan,
                            const FilteredScan& filtered,
                            const Interval& interval,
                            OdometryResult* result) {
  const EgoVelocity& velocity = result->ego_velocity;
  const Prediction prediction = Predict(radar, velocity, interval);
  // What stands now may have moved since the last pose, when that is some scans ago.
  const bool may_have_moved = radar.usual_interval > 0.0 &&
                              time_since_registered_ + interval.dt > 1.5 * radar.usual_interval &&
                              last_velocity_.norm() >= options_.ego_velocity.standing_speed;
  if (radar.submap->search() == nullptr) {
    // Nothing to register against yet: the first scan with enough returns starts the submap.
    result->T_world_radar = prediction.T_world_radar;
    result->covariance = covariance_;
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
    result->T_world_radar = T_world_body_ * radar.T_body_radar;
    result->covariance = covariance_;
  } else {
    Register(radar, filtered, prediction, interval.dt, result);
  }
  if (result->status != OdometryResult::Status::kPredicted) return;
  result->covariance = PredictedCovariance(velocity, radar, interval.dt);
  if (!velocity.valid && scan.has_doppler && options_.ego_velocity.enabled &&
      !velocity.reason.empty()) {
    result->reason = "ego velocity: " + velocity.reason;
  }
}

// What the next prediction starts from.
void Odometry::Impl::FollowMotion(const OdometryResult& result,
                                  const Interval& interval,
                                  Radar* radar) {
  const double own_dt = interval.own_dt;
  const bool has_velocity = HasVelocity(result.ego_velocity);
  radar->time_since_registered += own_dt;
  if (own_dt > 0.0) {
    // Over the interval of one radar: that between the scans of two can be too short.
    const Rigid3 T_last_now = radar->T_world_body.Inverse() * result.T_world_body;
    last_rate_ = RotationVector(T_last_now.rotation) / own_dt;
    if (!has_velocity) {
      const Eigen::Quaterniond half_back = QuaternionFromRotationVector(-0.5 * own_dt * last_rate_);
      last_velocity_ = half_back * T_last_now.translation / own_dt;
    }
    radar->usual_interval =
        radar->usual_interval == 0.0 ? own_dt : std::min(1.1 * radar->usual_interval, own_dt);
  }
  if (has_velocity) {
    last_velocity_ = radar->T_body_radar.rotation * result.ego_velocity.v_radar -
                     last_rate_.cross(radar->T_body_radar.translation);
  }
  radar->has_doppler_velocity = has_velocity;
  radar->v_doppler = result.ego_velocity.v_radar;
  covariance_ = result.covariance;
  time_since_registered_ = result.status == OdometryResult::Status::kPredicted
                               ? time_since_registered_ + interval.dt
                               : 0.0;
  T_world_body_ = result.T_world_body;
  last_stamp_ns_ = result.stamp_ns;
  if (result.status != OdometryResult::Status::kPredicted) radar->time_since_registered = 0.0;
  radar->has_scan = true;
  radar->stamp_ns = result.stamp_ns;
  radar->T_world_body = result.T_world_body;
}

bool Odometry::Impl::IsKeyframe(const Radar& radar, const OdometryResult& result) const {
  // Where the radar has seen nothing of its submap for long, the submap goes on at the prediction:
  // waiting for the old one would be forever.
  const bool is_lost = result.status == OdometryResult::Status::kPredicted &&
                       result.num_gaussians >= options_.registration.min_gaussians &&
                       radar.time_since_registered > options_.motion.restart_time;
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
  result.T_world_body = T_world_body_;
  result.T_world_radar = T_world_body_ * radar->T_body_radar;
  result.reason = WhyOutOfOrder(scan, *radar);
  if (!result.reason.empty()) {
    result.status = OdometryResult::Status::kSkipped;
    result.times_ms.total = stopwatch.Milliseconds();
    return result;
  }
  Interval interval;
  if (result.index > 0) interval.dt = Seconds(scan.stamp_ns - last_stamp_ns_);
  if (radar->has_scan) interval.own_dt = Seconds(scan.stamp_ns - radar->stamp_ns);

  const Stopwatch handover_stopwatch;
  radar->submap->NextScan();
  result.times_ms.submap = handover_stopwatch.Milliseconds();
  for (std::string& note : radar->submap->TakeNotes()) notes_.push_back(std::move(note));
  vehicle_.Advance(interval.dt);
  NoteMissingDoppler(scan);
  FilteredScan filtered = radar->filter.Filter(scan, &result);
  Locate(*radar, scan, filtered, interval, &result);
  result.T_world_body = result.T_world_radar * radar->T_body_radar.Inverse();
  FollowMotion(result, interval, radar);

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
