// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/motion_model.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "radive/odometry/scan_filter.h"

namespace radive {
namespace {

// How much worse a prediction gets with the time that no scan was seen, beyond what the velocity's
// covariance says: the velocity and the turning rate change meanwhile.
constexpr double kUnseenAcceleration = 0.15;  // share of t^2 in the position [m/s^2]

// Longest time without a scan over which a turning rate is carried on [s]: turns are short.
constexpr double kCarriedTurn = 3.0;

// Standard deviation of a rotation of which nothing is known [rad]: that of a uniform angle.
constexpr double kAnyRotation = 1.8;

// Stamps jitter; the noise of a motion in no time at all is not zero [s].
constexpr double kShortestInterval = 1e-3;

// Standard deviation of a velocity that is carried over from the last registered motion, for want
// of Doppler [m/s].
constexpr double kUnknownVelocity = 1.0;

}  // namespace

MotionModel::MotionModel(const OdometryOptions& options)
    : options_(options),
      T_vehicle_radar_(options.sensor.T_vehicle_radar()),
      up_world_(UpRadar(T_vehicle_radar_)),
      vehicle_(options.motion) {}

void MotionModel::Start(const Eigen::Vector3d& velocity) {
  if (has_doppler_velocity_ || (has_moved_ && time_since_registered_ == 0.0)) return;
  velocity_ = velocity;
}

// Time up to now in which no scan was seen, beyond the usual interval [s].
double MotionModel::UnseenTime(double dt) const {
  return usual_interval_ > 0.0 ? std::max(0.0, dt - usual_interval_) : 0.0;
}

double MotionModel::UnknownTime(double dt) const {
  return std::max(0.0, UnseenTime(dt) - kCarriedTime);
}

// Standard deviation of what the motion did in the time that no scan was seen [m].
double MotionModel::UnseenSigma(double dt) const {
  const double unseen = UnseenTime(dt);
  return kUnseenAcceleration * unseen * unseen;
}

MotionPrediction MotionModel::Predict(const EgoVelocity& velocity, double dt) const {
  const double turning_time = dt - std::max(0.0, UnseenTime(dt) - kCarriedTurn);
  dt -= UnknownTime(dt);
  MotionPrediction prediction;
  prediction.has_doppler = HasVelocity(velocity);
  if (prediction.has_doppler && has_doppler_velocity_) {
    // Each velocity is in its own radar frame; their mean belongs to the frame half-way.
    prediction.v_mean = 0.5 * velocity_ + 0.5 * velocity.v_radar;
  } else {
    prediction.v_mean = prediction.has_doppler ? velocity.v_radar : velocity_;
  }
  Eigen::Vector3d rate = rate_;
  if (const auto yaw_rate = prediction.has_doppler
                                ? vehicle_.YawRate(T_vehicle_radar_, prediction.v_mean)
                                : std::nullopt) {
    const Eigen::Vector3d up = UpRadar(T_vehicle_radar_);
    rate += up * (*yaw_rate - up.dot(rate));
  }
  const Eigen::Vector3d turn = turning_time * rate;
  const Eigen::Quaterniond half_turn = QuaternionFromRotationVector(0.5 * turn);
  prediction.T_world_radar = {T_world_radar_.rotation * QuaternionFromRotationVector(turn),
                              T_world_radar_.translation +
                                  T_world_radar_.rotation * (half_turn * (prediction.v_mean * dt))};
  return prediction;
}

RegistrationPriors MotionModel::Priors(const MotionPrediction& prediction,
                                       const EgoVelocity& velocity,
                                       bool is_planar,
                                       double dt) const {
  const MotionOptions& motion = options_.motion;
  RegistrationPriors priors;
  if (prediction.has_doppler && motion.doppler_prior) {
    const double time = std::max(dt, kShortestInterval);
    const double floor = motion.doppler_floor;
    const double unseen = UnseenSigma(dt);
    const double variance = time * time * floor * floor + unseen * unseen;
    priors.displacement = RegistrationPriors::Displacement{
        T_world_radar_,
        prediction.v_mean * dt,
        time * time * velocity.covariance + variance * Eigen::Matrix3d::Identity()};
  }
  if (motion.low_speed_lambda > 0.0 && prediction.has_doppler &&
      velocity.v_radar.norm() < motion.low_speed_limit) {
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
    priors.attitude_height = RegistrationPriors::AttitudeHeight{UpRadar(T_vehicle_radar_),
                                                                up_world_,
                                                                T_world_radar_.translation,
                                                                motion.attitude_sigma,
                                                                motion.height_sigma};
  }
  priors.no_slip = vehicle_.Prior(T_vehicle_radar_, T_world_radar_, prediction.v_mean, dt);
  if (priors.no_slip) priors.no_slip->sigma = std::hypot(priors.no_slip->sigma, UnseenSigma(dt));
  if (options_.registration.planar || is_planar) priors.plane_normal = up_world_;
  return priors;
}

Matrix6d MotionModel::PredictedCovariance(const EgoVelocity& velocity, double dt) const {
  Matrix6d covariance = covariance_;
  const double unknown = UnknownTime(dt);
  const double sigma_rotation = std::min(kUnseenRotationRate * dt, kAnyRotation);
  covariance.topLeftCorner<3, 3>().diagonal().array() += sigma_rotation * sigma_rotation;
  const Eigen::Matrix3d R = T_world_radar_.RotationMatrix();
  const double speed_now = HasVelocity(velocity) ? velocity.v_radar.norm() : 0.0;
  const Eigen::Matrix3d velocity_covariance =
      HasVelocity(velocity)
          ? velocity.covariance
          : Eigen::Matrix3d(kUnknownVelocity * kUnknownVelocity * Eigen::Matrix3d::Identity());
  const double carried = dt - unknown;
  covariance.bottomRightCorner<3, 3>() +=
      carried * carried * R * velocity_covariance * R.transpose();
  if (unknown > 0.0) {
    // It may have stood, or gone on as at the faster of both ends.
    const double speed = std::max({speed_now, velocity_.norm(), kUnknownVelocity});
    const double sigma = UnseenSigma(carried) + speed * unknown;
    covariance.bottomRightCorner<3, 3>().diagonal().array() += sigma * sigma;
  }
  return covariance;
}

void MotionModel::LearnSlip(const MotionPrediction& prediction,
                            double dt,
                            const RegistrationResult& registration) {
  if (!registration.converged || UnseenTime(dt) >= usual_interval_) return;
  vehicle_.Update(T_vehicle_radar_,
                  prediction.v_mean,
                  dt,
                  registration.lateral_residual,
                  registration.lateral_variance);
}

void MotionModel::Follow(const OdometryResult& result, double dt) {
  has_doppler_velocity_ = HasVelocity(result.ego_velocity);
  if (UnknownTime(dt) > 0.0) {
    rate_.setZero();  // that before the gap is over, and the velocity is all that there is
  } else if (dt > 0.0) {
    const Rigid3 T_last_now = T_world_radar_.Inverse() * result.T_world_radar;
    rate_ = RotationVector(T_last_now.rotation) / dt;
    if (!has_doppler_velocity_) {
      const Eigen::Quaterniond half_back = QuaternionFromRotationVector(-0.5 * dt * rate_);
      velocity_ = half_back * T_last_now.translation / dt;
    }
    usual_interval_ = usual_interval_ == 0.0 ? dt : std::min(1.1 * usual_interval_, dt);
  }
  if (has_doppler_velocity_) velocity_ = result.ego_velocity.v_radar;
  has_moved_ |= dt > 0.0 && result.status == OdometryResult::Status::kRegistered;
  covariance_ = result.covariance;
  time_since_registered_ =
      result.status == OdometryResult::Status::kPredicted ? time_since_registered_ + dt : 0.0;
  T_world_radar_ = result.T_world_radar;
}

}  // namespace radive
