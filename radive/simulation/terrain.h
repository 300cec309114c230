// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

namespace radive {

// The ground of the simulated world: its height over the plane z = 0 of the world frame, a sum of
// plane waves, so that slopes and their derivatives are exact. Without waves it is that plane.
class Terrain {
 public:
  // amplitude sin(wave_vector . p + phase)
  struct Wave {
    double amplitude = 0.0;                                 // [m]
    Eigen::Vector2d wave_vector = Eigen::Vector2d::Zero();  // [rad/m]
    double phase = 0.0;                                     // [rad]
  };

  struct Point {
    double height = 0.0;                                 // [m]
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  // [-]
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();   // [1/m]
  };

  Terrain() = default;
  explicit Terrain(std::vector<Wave> waves);

  bool is_flat() const { return waves_.empty(); }
  double Height(const Eigen::Vector2d& p) const;
  Point At(const Eigen::Vector2d& p) const;

  // Upward unit normal.
  Eigen::Vector3d Normal(const Eigen::Vector2d& p) const;

  // Distance along a ray to where it enters the ground; `max_distance` [m] when it does not before.
  // `direction` is unit; the ray starts above the ground.
  double Cast(const Eigen::Vector3d& origin,
              const Eigen::Vector3d& direction,
              double max_distance) const;

 private:
  std::vector<Wave> waves_;
  double steepest_ = 0.0;  // bound of the slope [-]
};

}  // namespace radive
