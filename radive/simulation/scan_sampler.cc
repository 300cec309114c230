// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/scan_sampler.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "radive/geometry/spherical.h"

namespace radive {
namespace {

constexpr double kEgoSize = 2.0;          // bounces on the own car lengthen the path by up to [m]
constexpr double kVehicleStrength = 0.5;  // of a vehicle's scatterers by its cross-section [1/m^2]
constexpr double kTargetSize = 2.0;       // in range [m]
constexpr int kMaxAttempts = 60;          // draws before a return is given up

bool IsReal(ReturnLabel label) {
  return label == ReturnLabel::kStatic || label == ReturnLabel::kMoving;
}

bool InView(const SensorModel& sensor, const Spherical& s) {
  return s.range >= sensor.min_range && s.range <= sensor.max_range &&
         std::abs(s.azimuth) <= sensor.azimuth.half_view &&
         (sensor.is_planar || std::abs(s.elevation) <= sensor.elevation.half_view);
}

Eigen::Vector3d NormalErrors(Random* random) {
  Eigen::Vector3d errors;
  for (int i = 0; i < 3; ++i) errors[i] = random->Normal();
  return errors;
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

struct ScanSampler::View {
  Rigid3 T_world_radar;
  Eigen::Matrix3d R_world_radar = Eigen::Matrix3d::Identity();
  Eigen::Vector3d v_radar = Eigen::Vector3d::Zero();  // radar frame [m/s]
  std::vector<MovingCar> cars;
  std::vector<Echo> scatterers;            // visible ones
  std::vector<double> cumulative_weights;  // of `scatterers`
  std::vector<Echo> sources;               // real echoes so far, which artefacts derive from
  std::vector<Mirror> mirrors;
  Random random{0};

  double StaticDoppler(const Eigen::Vector3d& position) const {
    return -position.normalized().dot(v_radar);
  }
};

ScanSampler::ScanSampler(const SimulationOptions& options, const RadarWorld& world)
    : options_(options), sensor_(options.Sensor()), world_(world) {}

void ScanSampler::Draw(const std::vector<MovingCar>& cars,
                       double share,
                       std::uint64_t seed,
                       RadarScan* scan,
                       GroundTruth* truth) const {
  View view;
  view.T_world_radar = truth->T_world_radar;
  view.R_world_radar = view.T_world_radar.RotationMatrix();
  view.v_radar = truth->v_radar;
  view.cars = cars;
  view.random = Random(seed);
  FindVisibleScatterers(&view);
  const double spread = sensor_.returns_spread * view.random.Normal();
  const auto count =
      static_cast<std::size_t>(share * sensor_.returns_per_scan * std::max(0.2, 1.0 + spread));
  for (std::size_t i = 0; i < count; ++i) {
    Echo echo;
    RadarReturn measured;
    if (!DrawReturn(&view, &echo, &measured)) continue;
    scan->returns.push_back(measured);
    truth->labels.push_back(echo.label);
    truth->noise_free_positions.push_back(echo.position);
  }
}

void ScanSampler::FindVisibleScatterers(View* view) const {
  for (const Scatterer& scatterer : world_.scatterers()) {
    AddIfVisible(scatterer, Eigen::Vector3d::Zero(), ReturnLabel::kStatic, view);
  }
  for (const MovingCar& car : view->cars) {
    const Eigen::Vector2d ahead(std::cos(car.heading), std::sin(car.heading));
    const Eigen::Vector2d left(-ahead.y(), ahead.x());
    const Eigen::Vector3d half = 0.5 * car.size;
    // Lamps and the edges of the bodywork: more of them the larger the vehicle.
    for (const double x : {-half.x(), half.x()}) {
      for (const double y : {-half.y(), half.y()}) {
        for (double z = 0.5; z < car.size.z(); z += 0.7) {
          const Eigen::Vector2d arm = x * ahead + y * left;
          Scatterer scatterer;
          scatterer.position << car.center + arm, car.ground + z;
          scatterer.strength = kVehicleStrength * car.size.y() * car.size.z();
          const Eigen::Vector3d velocity(car.velocity.x() - car.yaw_rate * arm.y(),
                                         car.velocity.y() + car.yaw_rate * arm.x(),
                                         car.climb);
          AddIfVisible(scatterer, velocity, ReturnLabel::kMoving, view);
        }
      }
    }
  }
}

void ScanSampler::AddIfVisible(const Scatterer& scatterer,
                               const Eigen::Vector3d& velocity,
                               ReturnLabel label,
                               View* view) const {
  const Eigen::Vector3d& origin = view->T_world_radar.translation;
  const Eigen::Vector3d offset = scatterer.position - origin;
  const double range = offset.norm();
  if (range > sensor_.max_range || range < sensor_.min_range) return;
  Echo echo;
  echo.position = view->R_world_radar.transpose() * offset;
  const Spherical s = ToSpherical(echo.position);
  if (!InView(sensor_, s)) return;
  // A scatterer sits on its surface, so the ray may end at it but not well before it.
  if (world_.Cast(origin, offset / range, range - 0.3, view->cars)) return;
  const double total = view->cumulative_weights.empty() ? 0.0 : view->cumulative_weights.back();
  view->cumulative_weights.push_back(total + scatterer.strength * Gain(sensor_.azimuth, s.azimuth) *
                                                 Gain(sensor_.elevation, s.elevation) *
                                                 DetectionProbability(range, /*reach=*/1.0));
  echo.doppler = velocity.dot(offset) / range + view->StaticDoppler(echo.position);
  echo.label = label;
  echo.errors = NormalErrors(&view->random);
  view->scatterers.push_back(echo);
}

// One return. Its kind is decided first and then tried until it succeeds, so that the shares of
// the kinds do not depend on how often each of them fails.
bool ScanSampler::DrawReturn(View* view, Echo* echo, RadarReturn* measured) const {
  using DrawKind = bool (ScanSampler::*)(View*, Echo*) const;
  const std::pair<double, DrawKind> artefacts[] = {
      {options_.ghost_share, &ScanSampler::DrawGhost},
      {options_.ground_ghost_share, &ScanSampler::DrawGroundGhost},
      {options_.clutter_share, &ScanSampler::DrawClutter},
      {options_.duplicate_share, &ScanSampler::DrawDuplicate}};
  DrawKind draw = nullptr;
  double kind = view->random.Uniform();
  for (const auto& [share, draw_artefact] : artefacts) {
    kind -= sensor_.artefacts * share;
    if (kind < 0.0) {
      draw = draw_artefact;
      break;
    }
  }
  if (draw == nullptr) {
    draw = view->random.Uniform() < sensor_.scatterer_share ? &ScanSampler::DrawScatterer
                                                            : &ScanSampler::DrawSurface;
  }
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    *echo = Echo();
    if (!(this->*draw)(view, echo) || !Measure(&view->random, echo, measured)) continue;
    if (IsReal(echo->label)) {
      view->sources.push_back(*echo);
      ConfuseElevation(view, echo, measured);
    }
    return true;
  }
  return false;
}

bool ScanSampler::DrawSurface(View* view, Echo* echo) const {
  Spherical ray;
  ray.range = 1.0;
  std::optional<double> range_of_target;
  if (!view->sources.empty() && view->random.Uniform() < sensor_.cluster_share) {
    const Echo& source = view->sources[view->random.Index(view->sources.size())];
    const Spherical beside = ToSpherical(source.position);
    ray.azimuth = beside.azimuth + sensor_.cluster_angle * view->random.Normal();
    ray.elevation = beside.elevation + sensor_.cluster_angle * view->random.Normal();
    range_of_target = beside.range;
    echo->has_errors = true;
    echo->errors = ErrorsLike(source.errors, &view->random);
  } else {
    ray.azimuth = DrawAngle(sensor_.azimuth, &view->random);
    ray.elevation = DrawAngle(sensor_.elevation, &view->random);
  }
  if (std::abs(ray.azimuth) > sensor_.azimuth.half_view ||
      std::abs(ray.elevation) > sensor_.elevation.half_view) {
    return false;
  }
  const Eigen::Vector3d direction = FromSpherical(ray);
  const Eigen::Vector3d direction_world = view->R_world_radar * direction;
  const auto hit =
      world_.Cast(view->T_world_radar.translation, direction_world, sensor_.max_range, view->cars);
  if (!hit) return false;
  if (range_of_target && std::abs(hit->distance - *range_of_target) > kTargetSize) return false;

  const Material& material = sensor_.material(hit->surface);
  const double cosine = std::max(0.0, -hit->normal.dot(direction_world));
  const double reflection =
      material.reflection *
      (material.rough + (1.0 - material.rough) * std::pow(cosine, material.sharpness));
  if (view->random.Uniform() > reflection * DetectionProbability(hit->distance, material.reach)) {
    return false;
  }

  echo->position = hit->distance * direction;
  echo->doppler = hit->velocity.dot(direction_world) - view->v_radar.dot(direction);
  echo->label = hit->surface == Surface::kMovingCar ? ReturnLabel::kMoving : ReturnLabel::kStatic;
  echo->penetration = material.penetration;
  if (material.is_mirror) {
    view->mirrors.push_back({echo->position, view->R_world_radar.transpose() * hit->normal});
  }
  return true;
}

bool ScanSampler::DrawScatterer(View* view, Echo* echo) const {
  if (view->scatterers.empty()) return DrawSurface(view, echo);
  const auto& weights = view->cumulative_weights;
  const double draw = view->random.Uniform() * weights.back();
  const auto found = std::upper_bound(weights.begin(), weights.end(), draw);
  const auto i = std::min(static_cast<std::size_t>(found - weights.begin()), weights.size() - 1);
  *echo = view->scatterers[i];
  echo->errors = ErrorsLike(echo->errors, &view->random);
  echo->has_errors = true;
  return true;
}

bool ScanSampler::DrawGhost(View* view, Echo* echo) const {
  if (view->sources.empty() || view->mirrors.empty()) return false;
  const Echo& source = view->sources[view->random.Index(view->sources.size())];
  echo->label = ReturnLabel::kGhost;
  if (view->random.Uniform() < 0.25) {
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

// The way between radar and target leads over the ground once or twice. Twice: the target's image
// below the ground. Once: half-way between both in range and Doppler, and it comes from one of the
// two directions.
bool ScanSampler::DrawGroundGhost(View* view, Echo* echo) const {
  if (view->sources.empty()) return false;
  const Echo& source = view->sources[view->random.Index(view->sources.size())];
  const Eigen::Vector3d p_world = view->T_world_radar * source.position;
  const double above = p_world.z() - world_.terrain().Height(p_world.head<2>());
  if (above < 0.2) return false;  // its image cannot be told from it
  const Eigen::Vector3d up_radar = view->R_world_radar.transpose() * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d image = source.position - 2.0 * above * up_radar;
  const double object_rate = source.doppler - view->StaticDoppler(source.position);
  const double image_doppler = view->StaticDoppler(image) + object_rate;
  echo->label = ReturnLabel::kGhost;
  const double kind = view->random.Uniform(0.0, 4.0);
  if (kind < 2.0) {
    echo->position = image;
    echo->doppler = image_doppler;
    return true;
  }
  const double range = 0.5 * (source.position.norm() + image.norm());
  echo->position = range * (kind < 3.0 ? image : source.position).normalized();
  echo->doppler = 0.5 * (source.doppler + image_doppler);
  return true;
}

bool ScanSampler::DrawClutter(View* view, Echo* echo) const {
  echo->label = ReturnLabel::kClutter;
  Spherical s;
  if (view->random.Uniform() < 0.3) {
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

bool ScanSampler::DrawDuplicate(View* view, Echo* echo) const {
  if (view->sources.empty()) return false;
  const Echo& source = view->sources[view->random.Index(view->sources.size())];
  if (source.penetration <= 0.0) return false;
  const double behind = 0.3 - source.penetration * std::log(1.0 - view->random.Uniform());
  echo->position = source.position + behind * source.position.normalized();
  echo->doppler = source.doppler;
  echo->label = ReturnLabel::kDuplicate;
  return true;
}

// Errors of another return of the same target.
Eigen::Vector3d ScanSampler::ErrorsLike(const Eigen::Vector3d& errors, Random* random) const {
  const double correlation = sensor_.target_correlation;
  return correlation * errors + std::sqrt(1.0 - correlation * correlation) * NormalErrors(random);
}

// Some real returns land on the next elevation that the antenna cannot tell from theirs.
void ScanSampler::ConfuseElevation(View* view, Echo* echo, RadarReturn* measured) const {
  if (sensor_.ambiguous_share <= 0.0 || sensor_.is_planar) return;
  if (view->random.Uniform() >= sensor_.ambiguous_share) return;
  Spherical s = ToSpherical(echo->position);
  s.elevation += s.elevation > 0.0 ? -sensor_.elevation_ambiguity : sensor_.elevation_ambiguity;
  Echo confused = *echo;
  confused.position = FromSpherical(s);
  confused.label = ReturnLabel::kAmbiguous;
  if (Measure(&view->random, &confused, measured)) *echo = confused;
}

// Adds noise; false when the measurement leaves the field of view.
bool ScanSampler::Measure(Random* random, Echo* echo, RadarReturn* measured) const {
  const Spherical truth = ToSpherical(echo->position);
  if (!InView(sensor_, truth)) return false;
  if (!echo->has_errors) {
    echo->errors = NormalErrors(random);
    echo->has_errors = true;
  }
  Spherical s = truth;
  s.range += sensor_.sigma_range * echo->errors[0];
  s.azimuth += sensor_.sigma_azimuth * echo->errors[1];
  s.elevation += sensor_.sigma_elevation * echo->errors[2];
  if (sensor_.is_planar) s.elevation = 0.0;
  if (!InView(sensor_, s)) return false;
  measured->position = FromSpherical(s);
  if (sensor_.is_planar) measured->position.z() = 0.0;
  measured->doppler = echo->doppler + sensor_.sigma_doppler * random->Normal();
  // Signal to noise ratio: falls slowly with range, lower for what is no first echo.
  measured->power = std::max(
      4.0, (IsReal(echo->label) ? 13.5 : 10.0) - 0.02 * truth.range + 3.5 * random->Normal());
  return true;
}

double ScanSampler::DetectionProbability(double range, double reach) const {
  const double ratio = range / (reach * sensor_.half_range);
  return 1.0 / (1.0 + ratio * ratio * ratio * ratio);
}

}  // namespace radive
