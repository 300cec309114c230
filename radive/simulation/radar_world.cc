// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/radar_world.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace radive {
namespace {

constexpr double kCell = 8.0;     // edge of a grid cell [m]
constexpr double kMargin = 1e-6;  // walls on a cell border belong to both cells [m]
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Whether a wall comes within kMargin of an axis-aligned cell (separating axes).
bool Touches(const WallSegment& wall, const Eigen::Vector2d& low) {
  const Eigen::Vector2d center = low.array() + 0.5 * kCell;
  const Eigen::Vector2d middle = 0.5 * (wall.a + wall.b) - center;
  const Eigen::Vector2d half = 0.5 * (wall.b - wall.a).cwiseAbs();
  const double reach = 0.5 * kCell + kMargin;
  if (std::abs(middle.x()) > reach + half.x() || std::abs(middle.y()) > reach + half.y()) {
    return false;
  }
  const Eigen::Vector2d edge = wall.b - wall.a;
  return std::abs(Cross(edge, middle)) <= reach * (std::abs(edge.x()) + std::abs(edge.y()));
}

// Distance to the box of a car by slabs in its own frame; infinity when missed.
double CastCar(const MovingCar& car,
               const Eigen::Vector3d& origin,
               const Eigen::Vector3d& direction,
               Eigen::Vector3d* normal) {
  const double c = std::cos(car.heading), s = std::sin(car.heading);
  const auto to_car = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(c * v.x() + s * v.y(), -s * v.x() + c * v.y(), v.z());
  };
  const Eigen::Vector3d o = to_car(
      origin - Eigen::Vector3d(car.center.x(), car.center.y(), car.ground + 0.5 * car.size.z()));
  const Eigen::Vector3d d = to_car(direction);
  const Eigen::Vector3d half = 0.5 * car.size;
  double enter = 0.0, leave = kInfinity;
  int axis = -1;
  for (int i = 0; i < 3; ++i) {
    if (d[i] == 0.0) {
      if (std::abs(o[i]) > half[i]) return kInfinity;
      continue;
    }
    const double t0 = (-std::copysign(half[i], d[i]) - o[i]) / d[i];
    const double t1 = (std::copysign(half[i], d[i]) - o[i]) / d[i];
    if (t0 > enter) {
      enter = t0;
      axis = i;
    }
    leave = std::min(leave, t1);
  }
  if (axis < 0 || enter > leave) return kInfinity;  // missed, or started inside
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  n[axis] = -std::copysign(1.0, d[axis]);
  *normal = Eigen::Vector3d(c * n.x() - s * n.y(), s * n.x() + c * n.y(), n.z());
  return enter;
}

}  // namespace

RadarWorld::RadarWorld(std::vector<WallSegment> walls,
                       std::vector<Scatterer> scatterers,
                       Terrain terrain,
                       double ceiling)
    : walls_(std::move(walls)),
      scatterers_(std::move(scatterers)),
      terrain_(std::move(terrain)),
      ceiling_(ceiling) {
  BuildGrid();
}

void RadarWorld::BuildGrid() {
  Eigen::Vector2d low(kInfinity, kInfinity), high(-kInfinity, -kInfinity);
  for (const WallSegment& wall : walls_) {
    CHECK(wall.a.allFinite() && wall.b.allFinite());
    low = low.cwiseMin(wall.a).cwiseMin(wall.b);
    high = high.cwiseMax(wall.a).cwiseMax(wall.b);
  }
  if (walls_.empty()) low = high = Eigen::Vector2d::Zero();
  grid_origin_ = low.array() - 0.5 * kCell;
  grid_width_ = static_cast<int>((high.x() - grid_origin_.x()) / kCell) + 1;
  grid_height_ = static_cast<int>((high.y() - grid_origin_.y()) / kCell) + 1;
  std::vector<std::vector<std::int32_t>> cells(static_cast<std::size_t>(grid_width_) *
                                               static_cast<std::size_t>(grid_height_));
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const WallSegment& wall = walls_[w];
    const Eigen::Vector2d from = (wall.a.cwiseMin(wall.b) - grid_origin_) / kCell;
    const Eigen::Vector2d to = (wall.a.cwiseMax(wall.b) - grid_origin_) / kCell;
    const int x_end = std::min(static_cast<int>(to.x()) + 1, grid_width_ - 1);
    const int y_end = std::min(static_cast<int>(to.y()) + 1, grid_height_ - 1);
    for (int y = std::max(static_cast<int>(from.y()) - 1, 0); y <= y_end; ++y) {
      for (int x = std::max(static_cast<int>(from.x()) - 1, 0); x <= x_end; ++x) {
        if (!Touches(wall, grid_origin_ + kCell * Eigen::Vector2d(x, y))) continue;
        cells[static_cast<std::size_t>(y * grid_width_ + x)].push_back(
            static_cast<std::int32_t>(w));
      }
    }
  }
  cell_begin_.push_back(0);
  for (const auto& cell : cells) {
    cell_walls_.insert(cell_walls_.end(), cell.begin(), cell.end());
    cell_begin_.push_back(static_cast<std::int32_t>(cell_walls_.size()));
  }
}

// Walks the cells under the ray in order and stops behind the first hit. `hit->distance` is the
// bound on entry.
bool RadarWorld::CastWalls(const Eigen::Vector3d& origin,
                           const Eigen::Vector3d& direction,
                           RayHit* hit) const {
  const Eigen::Vector2d o = origin.head<2>(), d = direction.head<2>();
  const double size[] = {kCell * grid_width_, kCell * grid_height_};
  double enter = 0.0, leave = hit->distance;
  for (int i = 0; i < 2; ++i) {
    const double from = grid_origin_[i] - o[i], to = from + size[i];
    if (d[i] == 0.0) {
      if (from > 0.0 || to < 0.0) return false;
      continue;
    }
    enter = std::max(enter, std::min(from / d[i], to / d[i]));
    leave = std::min(leave, std::max(from / d[i], to / d[i]));
  }
  if (enter >= leave) return false;

  const int limits[] = {grid_width_, grid_height_};
  int cell[2], step[2];
  double next[2], delta[2];  // distance to the next border along each axis, and between borders
  for (int i = 0; i < 2; ++i) {
    const double at = (o[i] + enter * d[i] - grid_origin_[i]) / kCell;
    cell[i] = std::clamp(static_cast<int>(at), 0, limits[i] - 1);
    step[i] = d[i] > 0.0 ? 1 : -1;
    const double border = grid_origin_[i] + kCell * (cell[i] + (d[i] > 0.0 ? 1 : 0));
    next[i] = d[i] == 0.0 ? kInfinity : (border - o[i]) / d[i];
    delta[i] = d[i] == 0.0 ? kInfinity : kCell / std::abs(d[i]);
  }
  int nearest = -1;
  while (true) {
    const auto index = static_cast<std::size_t>(cell[1] * grid_width_ + cell[0]);
    for (std::int32_t k = cell_begin_[index]; k < cell_begin_[index + 1]; ++k) {
      const std::int32_t w = cell_walls_[static_cast<std::size_t>(k)];
      const WallSegment& wall = walls_[static_cast<std::size_t>(w)];
      const Eigen::Vector2d edge = wall.b - wall.a, to_wall = wall.a - o;
      const double denominator = Cross(d, edge);
      if (denominator == 0.0) continue;
      const double along = Cross(to_wall, d) / denominator;
      if (!(along >= 0.0 && along <= 1.0)) continue;
      const double distance = Cross(to_wall, edge) / denominator;
      if (!(distance > 0.0 && distance < hit->distance)) continue;
      const double z = origin.z() + distance * direction.z();
      if (z < wall.base || z > wall.height) continue;
      hit->distance = distance;
      nearest = w;
    }
    const int axis = next[0] < next[1] ? 0 : 1;
    if (hit->distance <= next[axis] || next[axis] >= leave) break;
    cell[axis] += step[axis];
    if (cell[axis] < 0 || cell[axis] >= limits[axis]) break;
    next[axis] += delta[axis];
  }
  if (nearest < 0) return false;
  const WallSegment& wall = walls_[static_cast<std::size_t>(nearest)];
  const Eigen::Vector2d edge = (wall.b - wall.a).normalized();
  hit->normal = Eigen::Vector3d(-edge.y(), edge.x(), 0.0);
  if (hit->normal.dot(direction) > 0.0) hit->normal = -hit->normal;
  hit->surface = wall.surface;
  return true;
}

std::optional<RayHit> RadarWorld::Cast(const Eigen::Vector3d& origin,
                                       const Eigen::Vector3d& direction,
                                       double max_distance,
                                       const std::vector<MovingCar>& cars) const {
  RayHit hit;
  hit.distance = max_distance;
  bool found = false;
  const double to_ceiling =
      direction.z() > 0.0 ? (ceiling_ - origin.z()) / direction.z() : max_distance;
  if (to_ceiling < hit.distance) {
    hit.distance = to_ceiling;
    hit.surface = Surface::kConcrete;
    hit.normal = -Eigen::Vector3d::UnitZ();
    found = true;
  }
  found |= CastWalls(origin, direction, &hit);
  // The ground last of what stands still: on slopes it is searched for, no further than needed.
  const double to_ground = terrain_.Cast(origin, direction, hit.distance);
  if (to_ground < hit.distance) {
    hit.distance = to_ground;
    hit.surface = Surface::kGround;
    hit.normal = terrain_.Normal((origin + to_ground * direction).head<2>());
    found = true;
  }
  for (const MovingCar& car : cars) {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    const double distance = CastCar(car, origin, direction, &normal);
    if (distance >= hit.distance) continue;
    found = true;
    hit.distance = distance;
    hit.surface = Surface::kMovingCar;
    hit.normal = normal;
    const Eigen::Vector2d arm = (origin + distance * direction).head<2>() - car.center;
    hit.velocity << car.velocity.x() - car.yaw_rate * arm.y(),
        car.velocity.y() + car.yaw_rate * arm.x(), car.climb;
  }
  if (!found) return std::nullopt;
  return hit;
}

double RadarWorld::DistanceToSurface(const Eigen::Vector3d& point) const {
  double nearest =
      std::abs(point.z() - terrain_.Height(point.head<2>())) * terrain_.Normal(point.head<2>()).z();
  nearest = std::min(nearest, std::abs(ceiling_ - point.z()));
  for (const WallSegment& wall : walls_) {
    const Eigen::Vector2d edge = wall.b - wall.a;
    const double along =
        std::clamp((point.head<2>() - wall.a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    const double horizontal = (point.head<2>() - wall.a - along * edge).norm();
    const double vertical = std::max({0.0, point.z() - wall.height, wall.base - point.z()});
    nearest = std::min(nearest, std::hypot(horizontal, vertical));
  }
  return nearest;
}

}  // namespace radive
