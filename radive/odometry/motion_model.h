// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "radive/geometry/rigid3.h"
#include "radive/odometry/odometry_options.h"
#include "radive/odometry/odometry_result.h"
#include "radive/odometry/vehicle_model.h"
#include "radive/registration/registration.h"

namespace radive {

// Where the radar should be, before its scan is looked at.
struct MotionPrediction {
  Rigid3 T_world_radar;
  Eigen::Vector3d v_mean = Eigen::Vector3d::Zero();  // radar frame half-way [m/s]
  bool has_doppler = false;                          // v_mean is from the ego velocity
};

// Growth of a prediction's rotation error with the time that no scan was seen [rad/s].
constexpr double kUnseenRotationRate = 0.1;

// Longest time without a scan, beyond the usual interval, over which a velocity is carried on [s]:
// half of it from the velocity before and half from that behind. What happens in between nobody
// knows: the pose claims no motion there, and its covariance grows by what it may have been.
constexpr double kCarriedTime = 10.0;

// Motion of a radar from scan to scan: predicts the next pose, and says as priors of registration
// what is known of it. The world frame is the radar's at its first scan.
class MotionModel {
 public:
  explicit MotionModel(const OdometryOptions& options);

  // Where no motion has been seen yet, or none since some scans, the velocity to predict from: of
  // the radar, in its frame [m/s].
  void Start(const Eigen::Vector3d& velocity);

  // Lets `dt` [s] pass.
  void Advance(double dt) { vehicle_.Advance(dt); }

  MotionPrediction Predict(const EgoVelocity& velocity, double dt) const;
  RegistrationPriors Priors(const MotionPrediction& prediction,
                            const EgoVelocity& velocity,
                            bool is_planar,
                            double dt) const;
  // Of a pose that only the prediction moved: the last one's, and what the motion since adds.
  Matrix6d PredictedCovariance(const EgoVelocity& velocity, double dt) const;

  // What of `dt` is longer than a velocity is carried on [s]; 0: no gap, or a short one.
  double UnknownTime(double dt) const;

  // What registration says of the vehicle's slip angle.
  void LearnSlip(const MotionPrediction& prediction,
                 double dt,
                 const RegistrationResult& registration);
  // Corrects the pose of the last scan, so that it does not count as motion.
  void MoveTo(const Rigid3& T_world_radar) { T_world_radar_ = T_world_radar; }
  // Takes in the pose of a scan: what the next prediction starts from.
  void Follow(const OdometryResult& result, double dt);

  const Rigid3& T_world_radar() const { return T_world_radar_; }
  const Matrix6d& covariance() const { return covariance_; }               // of T_world_radar
  double speed() const { return velocity_.norm(); }                        // [m/s]
  double time_since_registered() const { return time_since_registered_; }  // [s]
  double usual_interval() const { return usual_interval_; }                // between scans [s]

 private:
  double UnseenTime(double dt) const;
  double UnseenSigma(double dt) const;

  const OdometryOptions options_;
  const Rigid3 T_vehicle_radar_;
  const Eigen::Vector3d up_world_;  // the vehicle's up axis at the start
  VehicleModel vehicle_;

  // At the last scan.
  Rigid3 T_world_radar_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  // radar frame [m/s]
  bool has_doppler_velocity_ = false;                   // velocity_ was measured
  bool has_moved_ = false;                              // velocity_ is that of a motion seen
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero();      // of turning, radar frame [rad/s]
  Matrix6d covariance_ = Matrix6d::Zero();
  double time_since_registered_ = 0.0;  // [s]
  double usual_interval_ = 0.0;         // [s]; 0: not known yet
};

}  // namespace radive
