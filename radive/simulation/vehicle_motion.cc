// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/vehicle_motion.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "radive/util/random.h"

namespace radive {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kKnotStep = 0.01;               // [s]
constexpr double kLimitStep = 0.5;               // [m]
constexpr double kMaxLateralAcceleration = 2.2;  // [m/s^2]; tracking adds up to 15 %
constexpr double kPlannedBraking = 1.3;          // [m/s^2]
constexpr double kMaxAcceleration = 1.8;         // [m/s^2]
constexpr double kMaxBraking = 3.0;              // [m/s^2]
constexpr double kMaxJerk = 4.0;                 // [m/s^3]
constexpr double kResponseTime = 0.6;            // of the simulated driver [s]
constexpr double kInitialHold = 1.5;             // standing at the start [s]
constexpr double kStopHold = 4.0;                // standing at the traffic light [s]
constexpr double kStopAt = 0.43;                 // where on the lap, as a share of its length

struct Value {
  double value = 0.0;
  double slope = 0.0;  // derivative by arc length
};

template <typename Waves>
Value Evaluate(const Waves& waves, double s) {
  Value sum;
  for (const auto& wave : waves) {
    const double angle = wave.wave_number * s + wave.phase;
    sum.value += wave.amplitude * std::sin(angle);
    sum.slope += wave.amplitude * wave.wave_number * std::cos(angle);
  }
  return sum;
}

}  // namespace

VehicleMotion::VehicleMotion(const StreetPath& path,
                             double max_speed,
                             double wobble,
                             std::uint64_t seed)
    : path_(path), next_stop_s_(kStopAt * path.length()), hold_until_(kInitialHold) {
  CHECK_GT(max_speed, 0.0);
  pitch_ = MakeWaves(wobble * 0.004, seed + 1);  // [rad]
  roll_ = MakeWaves(wobble * 0.005, seed + 2);   // [rad]
  heave_ = MakeWaves(wobble * 0.02, seed + 3);   // [m]
  ComputeSpeedLimits(max_speed);
  knots_.push_back({});
}

VehicleMotion::Waves VehicleMotion::MakeWaves(double amplitude, std::uint64_t seed) const {
  Random random(seed);
  const double base = 2.0 * kPi / path_.length();
  // Whole numbers of waves a lap, between 20-40 m and 8-13 m long.
  const auto long_count = static_cast<double>(25 + random.Index(25));
  const auto short_count = static_cast<double>(75 + random.Index(50));
  return {{{amplitude, base * long_count, random.Uniform(0.0, 2.0 * kPi)},
           {0.4 * amplitude, base * short_count, random.Uniform(0.0, 2.0 * kPi)}}};
}

// The highest speed at each place that keeps the lateral acceleration and can still brake for
// what comes.
void VehicleMotion::ComputeSpeedLimits(double max_speed) {
  const auto count = static_cast<std::size_t>(path_.length() / kLimitStep);
  const double step = path_.length() / static_cast<double>(count);
  speed_limits_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) * step;
    const double curvature = std::abs(path_.At(s).curvature);
    // Traffic never flows evenly: the cruising speed varies by 15 % along the lap.
    const double flow = 0.925 + 0.075 * std::cos(2.0 * kPi * 3.0 * s / path_.length());
    speed_limits_[i] =
        std::min(max_speed * flow, std::sqrt(kMaxLateralAcceleration / std::max(curvature, 1e-9)));
  }
  for (std::size_t pass = 0; pass < 2 * count; ++pass) {
    const std::size_t i = (2 * count - 1 - pass) % count;
    const double next = speed_limits_[(i + 1) % count];
    speed_limits_[i] =
        std::min(speed_limits_[i], std::sqrt(next * next + 2.0 * kPlannedBraking * step));
  }
}

double VehicleMotion::SpeedLimit(double s) const {
  const auto count = static_cast<double>(speed_limits_.size());
  const double lap = s / path_.length();
  const auto i = static_cast<std::size_t>((lap - std::floor(lap)) * count);
  return speed_limits_[std::min(i, speed_limits_.size() - 1)];
}

void VehicleMotion::AppendKnot() {
  const Travel last = knots_.back();
  const double time = static_cast<double>(knots_.size() - 1) * kKnotStep;
  double target = SpeedLimit(last.s + last.speed * kResponseTime);
  const double to_stop = next_stop_s_ - last.s - last.speed * kResponseTime;
  target = std::min(target, std::sqrt(2.0 * kPlannedBraking * std::max(0.0, to_stop)));
  const bool standing = last.speed == 0.0;
  if (standing && time < hold_until_) target = 0.0;

  const double wanted =
      std::clamp((target - last.speed) / kResponseTime, -kMaxBraking, kMaxAcceleration);
  double acceleration =
      last.acceleration +
      std::clamp(wanted - last.acceleration, -kMaxJerk * kKnotStep, kMaxJerk * kKnotStep);
  double speed = last.speed + acceleration * kKnotStep;
  const bool arrived = to_stop < 0.5 && speed < 0.02;
  if (arrived && !standing) {
    speed = 0.0;
    hold_until_ = time + kStopHold;
    next_stop_s_ += path_.length();
  }
  speed = std::max(0.0, speed);
  acceleration = (speed - last.speed) / kKnotStep;
  // The acceleration of a knot is that of the interval that begins there.
  knots_.back().acceleration = acceleration;
  knots_.push_back({last.s + 0.5 * (last.speed + speed) * kKnotStep, speed, acceleration});
}

VehicleMotion::Travel VehicleMotion::TravelAt(double time) {
  CHECK_GE(time, 0.0);
  const auto i = static_cast<std::size_t>(time / kKnotStep);
  while (knots_.size() < i + 2) AppendKnot();
  const Travel& knot = knots_[i];
  const double dt = time - static_cast<double>(i) * kKnotStep;
  const double speed = knot.speed + knot.acceleration * dt;
  return {knot.s + 0.5 * (knot.speed + speed) * dt, speed, knot.acceleration};
}

VehicleMotion::BodyState VehicleMotion::BodyAt(double time) {
  const Travel travel = TravelAt(time);
  const StreetPath::Point point = path_.At(travel.s);
  const Value pitch = Evaluate(pitch_, travel.s);
  const Value roll = Evaluate(roll_, travel.s);
  const Value heave = Evaluate(heave_, travel.s);

  BodyState state;
  state.T_world_body.translation << point.position, heave.value;
  state.T_world_body.rotation = Eigen::AngleAxisd(point.heading, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(pitch.value, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(roll.value, Eigen::Vector3d::UnitX());
  const Eigen::Vector3d v_world(travel.speed * std::cos(point.heading),
                                travel.speed * std::sin(point.heading),
                                travel.speed * heave.slope);
  state.v_body = state.T_world_body.rotation.conjugate() * v_world;
  // Body rates of Z-Y-X Euler angles.
  const double yaw_rate = travel.speed * point.curvature;
  const double pitch_rate = travel.speed * pitch.slope;
  const double roll_rate = travel.speed * roll.slope;
  const double sin_roll = std::sin(roll.value), cos_roll = std::cos(roll.value);
  const double cos_pitch = std::cos(pitch.value);
  state.omega_body << roll_rate - yaw_rate * std::sin(pitch.value),
      pitch_rate * cos_roll + yaw_rate * cos_pitch * sin_roll,
      -pitch_rate * sin_roll + yaw_rate * cos_pitch * cos_roll;
  return state;
}

}  // namespace radive
