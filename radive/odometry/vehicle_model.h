// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "radive/geometry/rigid3.h"
#include "radive/odometry/motion_options.h"
#include "radive/registration/registration.h"

namespace radive {

// The vehicle's up axis in the radar frame.
inline Eigen::Vector3d UpRadar(const Rigid3& T_vehicle_radar) {
  return T_vehicle_radar.rotation.conjugate() * Eigen::Vector3d::UnitZ();
}

// Kinematics of a road vehicle that carries the radars, self-calibrated while driving: the rear
// axle moves where it points, but for a slip angle that banked roads, tyres and errors of the
// mounting angle leave. The slip angle is followed as a first-order Gauss-Markov process by a
// Kalman filter whose measurement is registration itself (see
// RegistrationResult::lateral_residual).
class VehicleModel {
 public:
  explicit VehicleModel(const MotionOptions& options)
      : options_(options), slip_variance_(options.slip_sigma * options.slip_sigma) {}

  // Lets `dt` [s] pass: the slip angle fades and becomes less certain.
  void Advance(double dt);

  // Yaw rate [rad/s] that goes with a velocity of the radar [m/s] (radar frame). None when the
  // model is off, or the radar too close to the rear axle to feel its turning.
  std::optional<double> YawRate(const Rigid3& T_vehicle_radar,
                                const Eigen::Vector3d& v_radar) const;

  // The prior for a motion of `dt` [s] from `T_world_radar0` at about `v_radar`. None when the
  // model is off.
  std::optional<RegistrationPriors::NoSlip> Prior(const Rigid3& T_vehicle_radar,
                                                  const Rigid3& T_world_radar0,
                                                  const Eigen::Vector3d& v_radar,
                                                  double dt) const;

  // Takes in what registration left of the prior: the slip angle that fits best, and its variance.
  void Update(const Rigid3& T_vehicle_radar,
              const Eigen::Vector3d& v_radar,
              double dt,
              double lateral_residual,
              double lateral_variance);

  double slip() const { return slip_; }  // [rad], positive to the left

 private:
  // Distance from the point that does not slip sideways in a turn to the radar [m].
  double Lever(const Rigid3& T_vehicle_radar, double forward_speed) const;

  const MotionOptions options_;
  double slip_ = 0.0;     // [rad]
  double slip_variance_;  // [rad^2]
};

}  // namespace radive
