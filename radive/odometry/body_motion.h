// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>

#include "radive/geometry/rigid3.h"
#include "radive/odometry/odometry_options.h"
#include "radive/odometry/odometry_result.h"
#include "radive/odometry/vehicle_model.h"
#include "radive/registration/registration.h"

namespace radive {

// Time up to a scan [s].
struct ScanInterval {
  double dt = 0.0;      // since the last scan of any radar
  double own_dt = 0.0;  // since the last scan of the same radar; 0: none
};

// Where a radar should be, before its scan is looked at.
struct MotionPrediction {
  Rigid3 T_world_radar;
  Eigen::Vector3d v_mean = Eigen::Vector3d::Zero();  // of the radar, in its frame half-way [m/s]
  bool has_doppler = false;                          // v_mean is from the ego velocity
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();    // of turning, radar frame [rad/s]
};

// A radar on the body, and what its last scan left.
struct RadarMotion {
  Rigid3 T_vehicle_radar;
  Rigid3 T_body_radar;
  bool has_scan = false;
  std::int64_t stamp_ns = 0;                            // of its last scan
  Rigid3 T_world_body;                                  // then
  Eigen::Vector3d v_doppler = Eigen::Vector3d::Zero();  // then, in the radar frame [m/s]
  bool has_doppler_velocity = false;                    // v_doppler was measured
  double time_since_registered = 0.0;                   // [s]
  double usual_interval = 0.0;                          // between its scans [s]

  // Time up to now in which no scan was seen, beyond the usual interval [s].
  double UnseenTime(double dt) const {
    return usual_interval > 0.0 ? std::max(0.0, dt - usual_interval) : 0.0;
  }
};

// Growth of a prediction's rotation error with the time that no scan was seen [rad/s].
constexpr double kUnseenRotationRate = 0.1;

// Motion of the body from scan to scan, whichever radar sees it: predicts the next pose, and says
// as priors of registration what is known of it. The body is what the trajectory is of: the
// vehicle, or the radar of the first scan; its frame at the first scan is the world frame.
class BodyMotion {
 public:
  explicit BodyMotion(const OdometryOptions& options)
      : options_(options), vehicle_(options.motion) {}

  // A radar that has not been seen before. The first one may be the body.
  RadarMotion AddRadar(const Rigid3& T_vehicle_radar);

  // Lets `dt` [s] pass.
  void Advance(double dt) { vehicle_.Advance(dt); }

  MotionPrediction Predict(const RadarMotion& radar,
                           const EgoVelocity& velocity,
                           const ScanInterval& interval) const;
  RegistrationPriors Priors(const RadarMotion& radar,
                            const MotionPrediction& prediction,
                            const EgoVelocity& velocity,
                            bool is_planar,
                            double dt) const;
  // Of a pose that only the prediction moved: the last one's, and what the motion since adds.
  Matrix6d PredictedCovariance(const RadarMotion& radar,
                               const EgoVelocity& velocity,
                               double dt) const;

  // What registration says of the vehicle's slip angle.
  void LearnSlip(const RadarMotion& radar,
                 const MotionPrediction& prediction,
                 double dt,
                 const RegistrationResult& registration);
  // Takes in the pose of a scan: what the next prediction starts from.
  void Follow(const OdometryResult& result, const ScanInterval& interval, RadarMotion* radar);

  const Rigid3& T_world_body() const { return T_world_body_; }
  const Matrix6d& covariance() const { return covariance_; }               // of T_world_body
  double speed() const { return velocity_.norm(); }                        // [m/s]
  double time_since_registered() const { return time_since_registered_; }  // [s]

 private:
  Eigen::Vector3d VelocityOf(const RadarMotion& radar) const;
  void MoveToCentre(const RadarMotion& radar,
                    const MotionPrediction& prediction,
                    double dt,
                    RegistrationPriors::Displacement* prior) const;

  const OdometryOptions options_;
  VehicleModel vehicle_;
  int num_radars_ = 0;
  Rigid3 T_vehicle_first_;                                // the first radar
  Eigen::Vector3d centre_sum_ = Eigen::Vector3d::Zero();  // of the radars' places, body frame [m]
  Eigen::Vector3d up_world_ = Eigen::Vector3d::UnitZ();   // the vehicle's up axis at the start

  // At the last scan.
  Rigid3 T_world_body_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();  // body frame [m/s]
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero();      // body frame [rad/s]
  Matrix6d covariance_ = Matrix6d::Zero();
  double time_since_registered_ = 0.0;  // [s]
};

}  // namespace radive
