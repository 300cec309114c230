// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/traffic.h"

#include <cmath>

#include "radive/util/angle_units.h"
#include "radive/util/random.h"

namespace radive {
namespace {

constexpr double kOncomingLane = 4.0;   // left of the driving lane [m]
constexpr double kOncomingSpeed = 8.5;  // mean [m/s]
constexpr double kNextGap = 26.0;       // from one car ahead to the next [m]
constexpr double kNextHeadway = 1.2;    // [s]

}  // namespace

Traffic::Traffic(const StreetPath& path,
                 const Terrain& terrain,
                 const Options& options,
                 std::uint64_t seed)
    : path_(path), terrain_(terrain), options_(options) {
  Random random(seed);
  const int num_cars = options.num_cars;
  if (num_cars > 0) num_ahead_ = std::max(1, num_cars / 5);
  const int num_oncoming = num_cars - num_ahead_;
  for (int i = 0; i < num_oncoming; ++i) {
    Oncoming car;
    // All share the mean speed and the variation is small against the spacing: no collisions.
    const double spacing = path.length() / num_oncoming;
    car.start = spacing * (i + random.Uniform(-0.25, 0.25));
    car.amplitude = 0.1 * spacing;
    car.frequency = random.Uniform(0.08, 0.15);
    car.phase = random.Uniform(0.0, 2.0 * kPi);
    oncoming_.push_back(car);
  }
}

std::vector<MovingCar> Traffic::CarsAt(double time, const VehicleMotion::Travel& ego) const {
  std::vector<MovingCar> cars;
  for (int i = 0; i < num_ahead_; ++i) {
    // Distance from the rear axle of one to the centre of the other; it stands when the ego car
    // stands.
    const double gap = options_.lead_gap + kNextGap * i;
    const double headway = options_.lead_headway + kNextHeadway * i;
    cars.push_back(Place(ego.s + gap + headway * ego.speed,
                         std::max(0.0, ego.speed + headway * ego.acceleration),
                         0.0));
    if (i == 0 && options_.lead_is_truck) cars.back().size = {9.0, 2.5, 3.6};
  }
  for (const Oncoming& car : oncoming_) {
    const double angle = car.frequency * time + car.phase;
    const double s = car.start - kOncomingSpeed * time + car.amplitude * std::sin(angle);
    const double rate = -kOncomingSpeed + car.amplitude * car.frequency * std::cos(angle);
    cars.push_back(Place(s, rate, kOncomingLane));
  }
  return cars;
}

MovingCar Traffic::Place(double s, double s_rate, double lateral) const {
  const StreetPath::Point point = path_.At(s);
  const Eigen::Vector2d tangent(std::cos(point.heading), std::sin(point.heading));
  MovingCar car;
  car.center = point.position + lateral * Eigen::Vector2d(-tangent.y(), tangent.x());
  car.velocity = s_rate * (1.0 - lateral * point.curvature) * tangent;
  const Terrain::Point ground = terrain_.At(car.center);
  car.ground = ground.height;
  car.climb = ground.gradient.dot(car.velocity);
  car.yaw_rate = s_rate * point.curvature;
  car.heading = point.heading + (s_rate < 0.0 ? kPi : 0.0);
  return car;
}

}  // namespace radive
