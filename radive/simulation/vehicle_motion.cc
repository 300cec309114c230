// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/vehicle_motion.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "radive/util/angle_units.h"

namespace radive {
namespace {

constexpr double kKnotStep = 0.01;    // [s]
constexpr double kLimitStep = 0.5;    // [m]
constexpr double kInitialHold = 1.5;  // standing at the start [s]
constexpr double kStopHold = 4.0;     // standing at the traffic light [s]
constexpr double kStopAt = 0.43;      // where on the lap, as a share of its length

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
                             const Terrain& terrain,
                             const Options& options,
                             std::uint64_t seed)
    : path_(path),
      terrain_(terrain),
      options_(options),
      stops_(seed + 6),
      next_stop_s_(options.stop_distance > 0.0 ? options.stop_distance : kStopAt * path.length()),
      hold_until_(kInitialHold) {
  CHECK_GT(options.max_speed, 0.0);
  const VehicleStyle& style = options.style;
  pitch_ = MakeWaves(options.wobble * style.pitch, seed + 1);
  roll_ = MakeWaves(options.wobble * style.roll, seed + 2);
  heave_ = MakeWaves(options.wobble * style.heave, seed + 3);
  yaw_ = MakeWaves(options.wobble * style.yaw, seed + 4);
  sway_ = MakeWaves(options.wobble * style.sway, seed + 5);
  ComputeSpeedLimits();
  knots_.push_back({});
}

VehicleMotion::Waves VehicleMotion::MakeWaves(double amplitude, std::uint64_t seed) const {
  Random random(seed);
  const double base = 2.0 * kPi / path_.length();
  // Whole numbers of waves a lap.
  const auto fewest_long = static_cast<std::uint64_t>(path_.length() / options_.style.long_wave);
  const auto fewest_short = static_cast<std::uint64_t>(path_.length() / options_.style.short_wave);
  const auto long_count = static_cast<double>(fewest_long + random.Index(fewest_long));
  const auto short_count = static_cast<double>(fewest_short + random.Index(2 * fewest_short / 3));
  return {{{amplitude, base * long_count, random.Uniform(0.0, 2.0 * kPi)},
           {0.4 * amplitude, base * short_count, random.Uniform(0.0, 2.0 * kPi)}}};
}

// The highest speed at each place that keeps the lateral acceleration and can still brake for
// what comes.
void VehicleMotion::ComputeSpeedLimits() {
  const VehicleStyle& style = options_.style;
  const auto count = static_cast<std::size_t>(path_.length() / kLimitStep);
  const double step = path_.length() / static_cast<double>(count);
  speed_limits_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) * step;
    const double curvature = std::abs(path_.At(s).curvature);
    // Traffic never flows evenly: the cruising speed varies by 15 % along the lap.
    const double flow = 0.925 + 0.075 * std::cos(2.0 * kPi * 3.0 * s / path_.length());
    speed_limits_[i] =
        std::min(options_.max_speed * flow,
                 std::sqrt(style.max_lateral_acceleration / std::max(curvature, 1e-9)));
  }
  for (std::size_t pass = 0; pass < 2 * count; ++pass) {
    const std::size_t i = (2 * count - 1 - pass) % count;
    const double next = speed_limits_[(i + 1) % count];
    speed_limits_[i] =
        std::min(speed_limits_[i], std::sqrt(next * next + 2.0 * style.planned_braking * step));
  }
}

double VehicleMotion::SpeedLimit(double s) const {
  const auto count = static_cast<double>(speed_limits_.size());
  const double lap = s / path_.length();
  const auto i = static_cast<std::size_t>((lap - std::floor(lap)) * count);
  return speed_limits_[std::min(i, speed_limits_.size() - 1)];
}

void VehicleMotion::AppendKnot() {
  const VehicleStyle& style = options_.style;
  const Travel last = knots_.back();
  const double time = static_cast<double>(knots_.size() - 1) * kKnotStep;
  double target = SpeedLimit(last.s + last.speed * style.response_time);
  const double to_stop = next_stop_s_ - last.s - last.speed * style.response_time;
  target = std::min(target, std::sqrt(2.0 * style.planned_braking * std::max(0.0, to_stop)));
  const bool standing = last.speed == 0.0;
  if (standing && time < hold_until_) target = 0.0;

  const double wanted = std::clamp(
      (target - last.speed) / style.response_time, -style.max_braking, style.max_acceleration);
  double acceleration = last.acceleration + std::clamp(wanted - last.acceleration,
                                                       -style.max_jerk * kKnotStep,
                                                       style.max_jerk * kKnotStep);
  double speed = last.speed + acceleration * kKnotStep;
  const bool arrived = to_stop < 0.5 && speed < 0.02;
  if (arrived && !standing) {
    speed = 0.0;
    hold_until_ = time + kStopHold;
    next_stop_s_ += options_.stop_distance > 0.0 ? options_.stop_distance * stops_.Uniform(0.5, 1.5)
                                                 : path_.length();
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
  const Eigen::Vector2d tangent(std::cos(point.heading), std::sin(point.heading));
  const Eigen::Vector2d left(-tangent.y(), tangent.x());
  const Value heave = Evaluate(heave_, travel.s);
  const Value sway = Evaluate(sway_, travel.s);
  const Value yaw_wave = Evaluate(yaw_, travel.s);

  // In the plane. All slopes are derivatives by the arc length of the path.
  const Eigen::Vector2d position = point.position + sway.value * left;
  const Eigen::Vector2d direction =
      (1.0 - sway.value * point.curvature) * tangent + sway.slope * left;
  const Value yaw{point.heading + yaw_wave.value, point.curvature + yaw_wave.slope};
  // The ground along and across the path's tangent tilts the vehicle.
  const Terrain::Point ground = terrain_.At(position);
  const double along = ground.gradient.dot(tangent), across = ground.gradient.dot(left);
  const Eigen::Vector2d change = ground.hessian * direction;  // of the gradient
  const double along_slope = change.dot(tangent) + point.curvature * across;
  const double across_slope = change.dot(left) - point.curvature * along;
  const double tilt = -std::atan(along), tilt_slope = -along_slope / (1.0 + along * along);
  const double bank_tan = across * std::cos(tilt);
  const double bank_tan_slope =
      across_slope * std::cos(tilt) - across * std::sin(tilt) * tilt_slope;
  Value pitch = Evaluate(pitch_, travel.s);
  Value roll = Evaluate(roll_, travel.s);
  pitch.value += tilt;
  pitch.slope += tilt_slope;
  roll.value += std::atan(bank_tan);
  roll.slope += bank_tan_slope / (1.0 + bank_tan * bank_tan);

  BodyState state;
  state.T_world_body.translation << position, ground.height + heave.value;
  state.T_world_body.rotation = Eigen::AngleAxisd(yaw.value, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(pitch.value, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(roll.value, Eigen::Vector3d::UnitX());
  const double climb = ground.gradient.dot(direction) + heave.slope;
  const Eigen::Vector3d v_world =
      travel.speed * Eigen::Vector3d(direction.x(), direction.y(), climb);
  state.v_body = state.T_world_body.rotation.conjugate() * v_world;
  // Body rates of Z-Y-X Euler angles.
  const double yaw_rate = travel.speed * yaw.slope;
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
