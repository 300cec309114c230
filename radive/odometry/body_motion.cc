// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/body_motion.h"

#include <cmath>
#include <optional>

#include "radive/odometry/scan_filter.h"

namespace radive {
namespace {

// Standard deviation of a predicted turning rate [rad/s].
constexpr double kPredictedRateSigma = 0.03;

// Two radars may measure at the same time; the noise of a motion in no time at all is not zero [s].
constexpr double kShortestInterval = 1e-3;

// How much worse a prediction gets with the time that no scan was seen, beyond what the velocity's
// covariance says: the velocity and the turning rate change meanwhile.
constexpr double kUnseenAcceleration = 0.15;  // share of t^2 in the position [m/s^2]

// Standard deviation of a velocity that is carried over from the last registered motion, for want
// of Doppler [m/s].
constexpr double kUnknownVelocity = 1.0;

// Standard deviation of what the motion did in the time that no scan was seen [m].
double UnseenSigma(const RadarMotion& radar, double dt) {
  const double unseen = radar.UnseenTime(dt);
  return kUnseenAcceleration * unseen * unseen;
}

}  // namespace

RadarMotion BodyMotion::AddRadar(const Rigid3& T_vehicle_radar) {
  RadarMotion radar;
  radar.T_vehicle_radar = T_vehicle_radar;
  if (options_.motion.body == MotionOptions::Body::kVehicle) {
    radar.T_body_radar = T_vehicle_radar;
  } else if (num_radars_ > 0) {
    radar.T_body_radar = T_vehicle_first_.Inverse() * T_vehicle_radar;
  }
  if (num_radars_ == 0) {
    T_vehicle_first_ = T_vehicle_radar;
    up_world_ = radar.T_body_radar.rotation * UpRadar(T_vehicle_radar);
  }
  ++num_radars_;
  centre_sum_ += radar.T_body_radar.translation;
  return radar;
}

// Velocity of the radar [m/s] that goes with the body's, in the radar frame.
Eigen::Vector3d BodyMotion::VelocityOf(const RadarMotion& radar) const {
  return radar.T_body_radar.rotation.conjugate() *
         (velocity_ + rate_.cross(radar.T_body_radar.translation));
}

MotionPrediction BodyMotion::Predict(const RadarMotion& radar,
                                     const EgoVelocity& velocity,
                                     const ScanInterval& interval) const {
  const double dt = interval.dt;
  MotionPrediction prediction;
  prediction.has_doppler = HasVelocity(velocity);
  if (prediction.has_doppler && radar.has_doppler_velocity) {
    // Half-way through the last `dt`, linear in time since this radar's last scan. Each velocity is
    // in its own radar frame; what is between them belongs to the frame between.
    const double share_of_last = 0.5 * dt / interval.own_dt;
    prediction.v_mean = share_of_last * radar.v_doppler + (1.0 - share_of_last) * velocity.v_radar;
  } else {
    prediction.v_mean = prediction.has_doppler ? velocity.v_radar : VelocityOf(radar);
  }
  Eigen::Vector3d rate = rate_;
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
void BodyMotion::MoveToCentre(const RadarMotion& radar,
                              const MotionPrediction& prediction,
                              double dt,
                              RegistrationPriors::Displacement* prior) const {
  const Eigen::Vector3d centre = centre_sum_ / num_radars_;
  prior->lever = radar.T_body_radar.Inverse() * centre;
  prior->displacement += prediction.rate.cross(prior->lever) * dt;
  const Eigen::Vector3d sideways =
      UpRadar(radar.T_vehicle_radar).cross(prior->lever) * kPredictedRateSigma * dt;
  prior->covariance += sideways * sideways.transpose();
}

RegistrationPriors BodyMotion::Priors(const RadarMotion& radar,
                                      const MotionPrediction& prediction,
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
    if (num_radars_ > 1) MoveToCentre(radar, prediction, time, &*priors.displacement);
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

Matrix6d BodyMotion::PredictedCovariance(const RadarMotion& radar,
                                         const EgoVelocity& velocity,
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

void BodyMotion::LearnSlip(const RadarMotion& radar,
                           const MotionPrediction& prediction,
                           double dt,
                           const RegistrationResult& registration) {
  if (!registration.converged || radar.UnseenTime(dt) >= radar.usual_interval) return;
  vehicle_.Update(radar.T_vehicle_radar,
                  prediction.v_mean,
                  dt,
                  registration.lateral_residual,
                  registration.lateral_variance);
}

void BodyMotion::Follow(const OdometryResult& result,
                        const ScanInterval& interval,
                        RadarMotion* radar) {
  const double own_dt = interval.own_dt;
  const bool has_velocity = HasVelocity(result.ego_velocity);
  radar->time_since_registered += own_dt;
  if (own_dt > 0.0) {
    // Over the interval of one radar: that between the scans of two can be too short.
    const Rigid3 T_last_now = radar->T_world_body.Inverse() * result.T_world_body;
    rate_ = RotationVector(T_last_now.rotation) / own_dt;
    if (!has_velocity) {
      const Eigen::Quaterniond half_back = QuaternionFromRotationVector(-0.5 * own_dt * rate_);
      velocity_ = half_back * T_last_now.translation / own_dt;
    }
    radar->usual_interval =
        radar->usual_interval == 0.0 ? own_dt : std::min(1.1 * radar->usual_interval, own_dt);
  }
  if (has_velocity) {
    velocity_ = radar->T_body_radar.rotation * result.ego_velocity.v_radar -
                rate_.cross(radar->T_body_radar.translation);
  }
  radar->has_doppler_velocity = has_velocity;
  radar->v_doppler = result.ego_velocity.v_radar;
  covariance_ = result.covariance;
  time_since_registered_ = result.status == OdometryResult::Status::kPredicted
                               ? time_since_registered_ + interval.dt
                               : 0.0;
  T_world_body_ = result.T_world_body;
  if (result.status != OdometryResult::Status::kPredicted) radar->time_since_registered = 0.0;
  radar->has_scan = true;
  radar->stamp_ns = result.stamp_ns;
  radar->T_world_body = result.T_world_body;
}

}  // namespace radive
