// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "radive/simulation/terrain.h"

namespace radive {

// What a simulated radar can hit.
enum class Surface { kGround, kFacade, kPole, kParkedCar, kMovingCar, kVegetation, kConcrete };
constexpr int kNumSurfaces = 7;

// An upright rectangle over a line in the plane. World frame: z up.
struct WallSegment {
  Eigen::Vector2d a = Eigen::Vector2d::Zero();  // one end [m]
  Eigen::Vector2d b = Eigen::Vector2d::Zero();  // the other end [m]
  double height = 0.0;                          // z of its upper edge [m]
  Surface surface = Surface::kFacade;
  double base = 0.0;  // z of its lower edge [m]
};

// A point of the static world that answers far stronger than its surroundings, and in scan after
// scan: the edge of a bay, a pole, the corner of a parked car.
struct Scatterer {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  double strength = 1.0;                               // relative to the others [-], > 0
};

// A box that drives. Its frame: centre on the ground, x forward. It stays level on slopes.
struct MovingCar {
  Eigen::Vector3d size{4.4, 1.8, 1.5};                 // length, width, height [m]
  Eigen::Vector2d center = Eigen::Vector2d::Zero();    // [m]
  double ground = 0.0;                                 // height of the ground under it [m]
  double heading = 0.0;                                // [rad]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // of the centre [m/s]
  double climb = 0.0;                                  // upwards [m/s]
  double yaw_rate = 0.0;                               // [rad/s]
};

struct RayHit {
  double distance = 0.0;  // along the ray [m]
  Surface surface = Surface::kGround;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();   // unit, towards the side the ray came from
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // of the surface point, world frame [m/s]
};

// The static world, with exact ray casting over a uniform grid.
class RadarWorld {
 public:
  // `ceiling`: height of a roof over all of it, as in a tunnel [m]; infinity: the open sky.
  RadarWorld(std::vector<WallSegment> walls,
             std::vector<Scatterer> scatterers,
             Terrain terrain = {},
             double ceiling = std::numeric_limits<double>::infinity());

  // First surface along a ray of the world frame, or nothing within `max_distance` [m].
  // `direction` is unit. `cars` are the moving ones of the moment.
  std::optional<RayHit> Cast(const Eigen::Vector3d& origin,
                             const Eigen::Vector3d& direction,
                             double max_distance,
                             const std::vector<MovingCar>& cars) const;

  // Distance of `point` from the nearest static surface, the ground included [m]. Slow: for tests.
  double DistanceToSurface(const Eigen::Vector3d& point) const;

  const std::vector<WallSegment>& walls() const { return walls_; }
  const std::vector<Scatterer>& scatterers() const { return scatterers_; }
  const Terrain& terrain() const { return terrain_; }

 private:
  void BuildGrid();
  bool CastWalls(const Eigen::Vector3d& origin,
                 const Eigen::Vector3d& direction,
                 RayHit* hit) const;

  std::vector<WallSegment> walls_;
  std::vector<Scatterer> scatterers_;
  Terrain terrain_;
  double ceiling_;

  // Grid cell i lists the walls cell_walls_[cell_begin_[i]] to cell_walls_[cell_begin_[i + 1] - 1].
  Eigen::Vector2d grid_origin_ = Eigen::Vector2d::Zero();  // [m]
  int grid_width_ = 0, grid_height_ = 0;                   // cells along x and y
  std::vector<std::int32_t> cell_begin_, cell_walls_;
};

}  // namespace radive
