// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/vehicle_model.h"

#include <algorithm>
#include <cmath>

namespace radive {
namespace {

// A shorter lever turns the noise of the lateral velocity into too much yaw rate [m].
constexpr double kMinLever = 1.0;

double Square(double x) { return x * x; }

double ForwardSpeed(const Rigid3& T_vehicle_radar, const Eigen::Vector3d& v_radar) {
  return (T_vehicle_radar.rotation * v_radar).x();
}

}  // namespace

double VehicleModel::Lever(const Rigid3& T_vehicle_radar, double forward_speed) const {
  // Tyres drift outwards in proportion to the lateral acceleration v w, so that the point without
  // slip moves ahead by compliance v^2. The linear law ends somewhere: at half the lever.
  const double lever = T_vehicle_radar.translation.x();
  const double ahead = options_.slip_compliance * Square(forward_speed);
  return lever - std::min(ahead, 0.5 * std::abs(lever));  // a radar at the rear has lever < 0
}

void VehicleModel::Advance(double dt) {
  const double keep = std::exp(-dt / options_.slip_time);
  slip_ *= keep;
  slip_variance_ =
      Square(keep) * slip_variance_ + (1.0 - Square(keep)) * Square(options_.slip_sigma);
}

std::optional<double> VehicleModel::YawRate(const Rigid3& T_vehicle_radar,
                                            const Eigen::Vector3d& v_radar) const {
  if (!options_.no_slip) return std::nullopt;
  const Eigen::Vector3d v_vehicle = T_vehicle_radar.rotation * v_radar;
  const double lever = Lever(T_vehicle_radar, v_vehicle.x());
  if (lever < kMinLever) return std::nullopt;
  return (v_vehicle.y() - slip_ * v_vehicle.x()) / lever;
}

std::optional<RegistrationPriors::NoSlip> VehicleModel::Prior(const Rigid3& T_vehicle_radar,
                                                              const Rigid3& T_world_radar0,
                                                              const Eigen::Vector3d& v_radar,
                                                              double dt) const {
  if (!options_.no_slip) return std::nullopt;
  const double forward = ForwardSpeed(T_vehicle_radar, v_radar);
  RegistrationPriors::NoSlip prior;
  prior.T_submap_radar0 = T_world_radar0;
  prior.T_e_radar = T_vehicle_radar;
  prior.T_e_radar.translation.x() = Lever(T_vehicle_radar, forward);
  prior.lateral_offset = slip_ * forward * dt;
  prior.sigma = std::sqrt(Square(options_.no_slip_floor) + Square(options_.no_slip_sigma * dt) +
                          Square(forward * dt) * slip_variance_);
  return prior;
}

// The residual e of the prior is split between noise and slip angle as their variances stand:
// minimising e^2 / (n^2 + h^2 P) over the pose is minimising (e - h ds)^2 / n^2 + ds^2 / P over
// pose and slip angle, whose best ds is P h e / (n^2 + h^2 P).
void VehicleModel::Update(const Rigid3& T_vehicle_radar,
                          const Eigen::Vector3d& v_radar,
                          double dt,
                          double lateral_residual,
                          double lateral_variance) {
  if (!options_.no_slip) return;
  const double h = ForwardSpeed(T_vehicle_radar, v_radar) * dt;
  const double noise = Square(options_.no_slip_floor) + Square(options_.no_slip_sigma * dt);
  slip_ += slip_variance_ * h * lateral_residual / (noise + Square(h) * slip_variance_);
  slip_variance_ = 1.0 / (1.0 / slip_variance_ + Square(h) / (noise + lateral_variance));
}

}  // namespace radive
