// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

namespace radive {

// What a simulated radar can hit. World frame: z up, the ground is z = 0.
enum class Surface { kGround, kFacade, kPole, kParkedCar, kMovingCar };

// An upright rectangle over a line in the ground plane.
struct WallSegment {
  Eigen::Vector2d a = Eigen::Vector2d::Zero();  // one end [m]
  Eigen::Vector2d b = Eigen::Vector2d::Zero();  // the other end [m]
  double height = 0.0;                          // reaches from the ground up to here [m]
  Surface surface = Surface::kFacade;
};

// A point of the static world that answers far stronger than its surroundings, and in scan after
// scan: the edge of a bay, a pole, the corner of a parked car.
struct Scatterer {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  double strength = 1.0;                               // relative to the others [-], > 0
};

// A box that drives. Its frame: centre on the ground, x forward.
struct MovingCar {
  static constexpr double kLength = 4.4;  // [m]
  static constexpr double kWidth = 1.8;   // [m]
  static constexpr double kHeight = 1.5;  // [m]

  Eigen::Vector2d center = Eigen::Vector2d::Zero();    // [m]
  double heading = 0.0;                                // [rad]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // of the centre [m/s]
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
  RadarWorld(std::vector<WallSegment> walls, std::vector<Scatterer> scatterers);

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

 private:
  void BuildGrid();
  bool CastWalls(const Eigen::Vector3d& origin,
                 const Eigen::Vector3d& direction,
                 RayHit* hit) const;

  std::vector<WallSegment> walls_;
  std::vector<Scatterer> scatterers_;

  // Grid cell i lists the walls cell_walls_[cell_begin_[i]] to cell_walls_[cell_begin_[i + 1] - 1].
  Eigen::Vector2d grid_origin_ = Eigen::Vector2d::Zero();  // [m]
  int grid_width_ = 0, grid_height_ = 0;                   // cells along x and y
  std::vector<std::int32_t> cell_begin_, cell_walls_;
};

}  // namespace radive
