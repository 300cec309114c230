// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/radar_simulator.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "radive/geometry/spherical.h"
#include "radive/simulation/street_builder.h"

namespace radive {
namespace {

// The loop is 1006 m long.
constexpr double kLongSide = 270.0;   // [m]
constexpr double kShortSide = 113.0;  // [m]
constexpr double kCorner = 60.0;      // [m], tightest radius 19 m

constexpr double kGroundReflection = 0.06;  // chance that a ray which meets the road comes back
constexpr double kEgoSize = 2.0;            // bounces on the own car lengthen the path by up to [m]
constexpr int kMaxAttempts = 60;            // draws before a return is given up

std::uint64_t SeedOf(int seed, std::uint64_t purpose) {
  return Random(static_cast<std::uint64_t>(seed) * 0x100000001B3ull + purpose).Bits();
}

const SimulationOptions& Checked(const SimulationOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  return options;
}

bool InView(const SensorModel& sensor, const Spherical& s) {
  return s.range >= sensor.min_range && s.range <= sensor.max_range &&
         std::abs(s.azimuth) <= sensor.azimuth.half_view &&
         (sensor.is_planar || std::abs(s.elevation) <= sensor.elevation.half_view);
}

double DrawAngle(const BeamPattern& beam, Random* random) {
  if (random->Uniform() < beam.floor_share) {
    return random->Uniform(-beam.half_view, beam.half_view);
  }
  return beam.center + beam.lobe * random->Normal();
}

// Density of DrawAngle relative to that of the main lobe at its centre.
double Gain(const BeamPattern& beam, double angle) {
  const double offset = (angle - beam.center) / beam.lobe;
  const double lobe = (1.0 - beam.floor_share) * std::exp(-0.5 * offset * offset);
  return lobe + beam.floor_share * beam.lobe * std::sqrt(2.0 * 3.14159265358979323846) /
                    (2.0 * beam.half_view);
}

}  // namespace

struct RadarSimulator::View {
  Rigid3 T_world_radar;
  Eigen::Matrix3d R_world_radar = Eigen::Matrix3d::Identity();
  Eigen::Vector3d v_radar = Eigen::Vector3d::Zero();  // radar frame [m/s]
  std::vector<MovingCar> cars;
  std::vector<Eigen::Vector3d> scatterers;  // visible ones, radar frame [m]
  std::vector<double> cumulative_weights;   // of `scatterers`
  std::vector<Echo> sources;                // real echoes so far, which artefacts derive from
  std::vector<Mirror> mirrors;
  Random random{0};

  double StaticDoppler(const Eigen::Vector3d& position) const {
    return -position.normalized().dot(v_radar);
  }
};

RadarSimulator::RadarSimulator(const SimulationOptions& options)
    : options_(Checked(options)),
      sensor_(options.Sensor()),
      path_(kLongSide, kShortSide, kCorner),
      world_(BuildStreet(path_, SeedOf(options.seed, 1))),
      traffic_(path_, options.moving_cars, SeedOf(options.seed, 2)),
      motion_(path_, options.max_speed, options.wobble, SeedOf(options.seed, 3)),
      T_body_radar_(
          Eigen::Quaterniond(Eigen::AngleAxisd(options.mount_yaw, Eigen::Vector3d::UnitZ())),
          Eigen::Vector3d(
              options.mount_position[0], options.mount_position[1], options.mount_position[2])) {}

std::int64_t RadarSimulator::StampOf(int k) const {
  return std::llround(static_cast<double>(k) * 1e9 / sensor_.rate);
}

double RadarSimulator::TravelledAt(int k) {
  return motion_.TravelAt(static_cast<double>(StampOf(k)) * 1e-9).s;
}

bool RadarSimulator::Next(RadarScan* scan, GroundTruth* truth) {
  if (next_scan_ >= options_.frames) return false;
  const int k = next_scan_++;
  *scan = RadarScan();
  *truth = GroundTruth();
  scan->stamp_ns = StampOf(k);
  scan->has_doppler = true;
  scan->is_planar = sensor_.is_planar;
  scan->place = "simulated scan " + std::to_string(k);

  const double time = static_cast<double>(scan->stamp_ns) * 1e-9;
  const VehicleMotion::BodyState body = motion_.BodyAt(time);
  View view;
  view.T_world_radar = body.T_world_body * T_body_radar_;
  view.R_world_radar = view.T_world_radar.RotationMatrix();
  view.v_radar = T_body_radar_.rotation.conjugate() *
                 (body.v_body + body.omega_body.cross(T_body_radar_.translation));
  view.cars = traffic_.CarsAt(time, motion_.TravelAt(time));
  view.random = Random(SeedOf(options_.seed, 1000 + static_cast<std::uint64_t>(k)));
  FindVisibleScatterers(&view);
  truth->T_world_radar = view.T_world_radar;
  truth->v_radar = view.v_radar;

  const double spread = sensor_.returns_spread * view.random.Normal();
  const auto count =
      static_cast<std::size_t>(sensor_.returns_per_scan * std::max(0.2, 1.0 + spread));
  for (std::size_t i = 0; i < count; ++i) {
    Echo echo;
    RadarReturn measured;
    if (!DrawReturn(&view, &echo, &measured)) continue;
    scan->returns.push_back(measured);
    truth->labels.push_back(echo.label);
    truth->noise_free_positions.push_back(echo.position);
  }
  return true;
}

void RadarSimulator::FindVisibleScatterers(View* view) const {
  const Eigen::Vector3d& origin = view->T_world_radar.translation;
  double total = 0.0;
  for (const Scatterer& scatterer : world_.scatterers()) {
    const Eigen::Vector3d offset = scatterer.position - origin;
    const double range = offset.norm();
    if (range > sensor_.max_range || range < sensor_.min_range) continue;
    const Eigen::Vector3d position = view->R_world_radar.transpose() * offset;
    const Spherical s = ToSpherical(position);
    if (!InView(sensor_, s)) continue;
    // A scatterer sits on its surface, so the ray may end at it but not well before it.
    const auto hit = world_.Cast(origin, offset / range, range - 0.3, view->cars);
    if (hit) continue;
    total += scatterer.strength * Gain(sensor_.azimuth, s.azimuth) *
             Gain(sensor_.elevation, s.elevation) * DetectionProbability(range);
    view->scatterers.push_back(position);
    view->cumulative_weights.push_back(total);
  }
}

// One return. Its kind is decided first and then tried until it succeeds, so that the shares of
// the kinds do not depend on how often each of them fails.
bool RadarSimulator::DrawReturn(View* view, Echo* echo, RadarReturn* measured) const {
  using Draw = bool (RadarSimulator::*)(View*, Echo*) const;
  Draw draw = nullptr;
  double kind = view->random.Uniform();
  if ((kind -= options_.ghost_share) < 0.0) {
    draw = &RadarSimulator::DrawGhost;
  } else if ((kind -= options_.clutter_share) < 0.0) {
    draw = &RadarSimulator::DrawClutter;
  } else if ((kind -= options_.duplicate_share) < 0.0) {
    draw = &RadarSimulator::DrawDuplicate;
  } else if (view->random.Uniform() < sensor_.scatterer_share) {
    draw = &RadarSimulator::DrawScatterer;
  } else {
    draw = &RadarSimulator::DrawSurface;
  }
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    if (!(this->*draw)(view, echo) || !Measure(*echo, &view->random, measured)) continue;
    const bool is_real = echo->label == ReturnLabel::kStatic || echo->label == ReturnLabel::kMoving;
    if (is_real) view->sources.push_back(*echo);
    return true;
  }
  return false;
}

bool RadarSimulator::DrawSurface(View* view, Echo* echo) const {
  Spherical ray;
  ray.range = 1.0;
  ray.azimuth = DrawAngle(sensor_.azimuth, &view->random);
  ray.elevation = DrawAngle(sensor_.elevation, &view->random);
  if (std::abs(ray.azimuth) > sensor_.azimuth.half_view ||
      std::abs(ray.elevation) > sensor_.elevation.half_view) {
    return false;
  }
  const Eigen::Vector3d direction = FromSpherical(ray);
  const Eigen::Vector3d direction_world = view->R_world_radar * direction;
  const auto hit =
      world_.Cast(view->T_world_radar.translation, direction_world, sensor_.max_range, view->cars);
  if (!hit) return false;

  // Rough surfaces still answer at grazing incidence, only less.
  double reflection = 0.25 + 0.75 * -hit->normal.dot(direction_world);
  if (hit->surface == Surface::kGround) reflection = kGroundReflection;
  if (view->random.Uniform() > reflection * DetectionProbability(hit->distance)) return false;

  echo->position = hit->distance * direction;
  echo->doppler = hit->velocity.dot(direction_world) - view->v_radar.dot(direction);
  echo->label = hit->surface == Surface::kMovingCar ? ReturnLabel::kMoving : ReturnLabel::kStatic;
  if (hit->surface == Surface::kFacade) {
    view->mirrors.push_back({echo->position, view->R_world_radar.transpose() * hit->normal});
  }
  return true;
}

bool RadarSimulator::DrawScatterer(View* view, Echo* echo) const {
  if (view->scatterers.empty()) return DrawSurface(view, echo);
  const auto& weights = view->cumulative_weights;
  const double draw = view->random.Uniform() * weights.back();
  const auto found = std::upper_bound(weights.begin(), weights.end(), draw);
  const auto i = static_cast<std::size_t>(found - weights.begin());
  echo->position = view->scatterers[std::min(i, weights.size() - 1)];
  echo->doppler = view->StaticDoppler(echo->position);
  echo->label = ReturnLabel::kStatic;
  return true;
}

bool RadarSimulator::DrawGhost(View* view, Echo* echo) const {
  if (view->sources.empty() || view->mirrors.empty()) return false;
  const Echo& source = view->sources[view->random.Index(view->sources.size())];
  echo->label = ReturnLabel::kGhost;
  if (view->random.Uniform() < 0.5) {
    // Wall, own car, wall: twice the way, twice the Doppler.
    const double range = source.position.norm();
    const double longer = 2.0 * range - view->random.Uniform(0.0, kEgoSize);
    echo->position = source.position * (longer / range);
    echo->doppler = 2.0 * source.doppler;
    return longer > range;
  }
  // Radar, wall, target, wall: the image of the target behind the wall. For a static target it
  // moves like any static point, which is what makes these ghosts hard to reject.
  const Mirror& mirror = view->mirrors[view->random.Index(view->mirrors.size())];
  const double in_front = (source.position - mirror.point).dot(mirror.normal);
  if (in_front < 1.0) return false;
  echo->position = source.position - 2.0 * in_front * mirror.normal;
  const double object_rate = source.doppler - view->StaticDoppler(source.position);
  echo->doppler = view->StaticDoppler(echo->position) + object_rate;
  return true;
}

bool RadarSimulator::DrawClutter(View* view, Echo* echo) const {
  echo->label = ReturnLabel::kClutter;
  Spherical s;
  if (view->random.Uniform() < 0.5) {
    // A noise peak: anywhere, at any speed.
    s.range = view->random.Uniform(sensor_.min_range, sensor_.max_range);
    s.azimuth = view->random.Uniform(-sensor_.azimuth.half_view, sensor_.azimuth.half_view);
    s.elevation = view->random.Uniform(-sensor_.elevation.half_view, sensor_.elevation.half_view);
    echo->position = FromSpherical(s);
    echo->doppler = view->random.Uniform(-25.0, 25.0);
    return true;
  }
  // A side lobe: range and Doppler of a real return in a wrong direction.
  if (view->sources.empty()) return false;
  const Echo& source = view->sources[view->random.Index(view->sources.size())];
  s = ToSpherical(source.position);
  const double side = view->random.Uniform() < 0.5 ? -1.0 : 1.0;
  s.azimuth += side * view->random.Uniform(0.1, 0.5);
  echo->position = FromSpherical(s);
  echo->doppler = source.doppler;
  return true;
}

bool RadarSimulator::DrawDuplicate(View* view, Echo* echo) const {
  if (view->sources.empty()) return false;
  const Echo& source = view->sources[view->random.Index(view->sources.size())];
  const double behind = view->random.Uniform(0.6, 3.0);
  echo->position = source.position + behind * source.position.normalized();
  echo->doppler = source.doppler;
  echo->label = ReturnLabel::kDuplicate;
  return true;
}

// Adds noise; false when the measurement leaves the field of view.
bool RadarSimulator::Measure(const Echo& echo, Random* random, RadarReturn* measured) const {
  const Spherical truth = ToSpherical(echo.position);
  if (!InView(sensor_, truth)) return false;
  Spherical s = truth;
  s.range += sensor_.sigma_range * random->Normal();
  s.azimuth += sensor_.sigma_azimuth * random->Normal();
  s.elevation += sensor_.sigma_elevation * random->Normal();
  if (sensor_.is_planar) s.elevation = 0.0;
  if (!InView(sensor_, s)) return false;
  measured->position = FromSpherical(s);
  if (sensor_.is_planar) measured->position.z() = 0.0;
  measured->doppler = echo.doppler + sensor_.sigma_doppler * random->Normal();
  // Signal to noise ratio: falls slowly with range, lower for what is no first echo.
  const bool first = echo.label == ReturnLabel::kStatic || echo.label == ReturnLabel::kMoving;
  measured->power =
      std::max(4.0, (first ? 13.5 : 10.0) - 0.02 * truth.range + 3.5 * random->Normal());
  return true;
}

double RadarSimulator::DetectionProbability(double range) const {
  const double ratio = range / sensor_.half_range;
  return 1.0 / (1.0 + ratio * ratio * ratio * ratio);
}

}  // namespace radive
