// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

namespace radive {

// The line that the simulated car follows: a closed loop of four straight sides and four left
// corners (a rounded rectangle of about 1 km), driven counter-clockwise.
//
// Curvature and its derivative are continuous, as on a driven street: over a corner of length c
// it is (pi / 2 / c) (1 - cos(2 pi u / c)), u in [0, c] [1/m], so that yaw rate and lateral
// acceleration have no steps.
class StreetPath {
 public:
  struct Point {
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  // in the world frame [m]
    double heading = 0.0;                                // [rad], continuous within a lap
    double curvature = 0.0;                              // [1/m], positive to the left
  };

  static constexpr int kNumSides = 4;

  // Arc lengths of the even sides, the odd sides and of each corner [m].
  StreetPath(double long_side, double short_side, double corner);

  double length() const { return length_; }  // [m]

  // Point at arc length s [m]; any s, taken modulo the length of the loop.
  Point At(double s) const;

  // Frame of side i: x along the straight from its first point, y to the left. Points of the
  // world in it: origin + x * along + y * left.
  struct Side {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // [m]
    Eigen::Vector2d along = Eigen::Vector2d::UnitX();
    Eigen::Vector2d left = Eigen::Vector2d::UnitY();
    double straight = 0.0;  // length of its straight part [m]
    double start_s = 0.0;   // arc length at its first point [m]
    Eigen::Vector2d ToWorld(double x, double y) const { return origin + x * along + y * left; }
  };
  const Side& side(int i) const { return sides_[static_cast<std::size_t>(i)]; }

  // How far a corner reaches along either of its sides [m]: the lines of side i and i + 1 cross
  // at x = straight + corner_reach() of side i.
  double corner_reach() const { return corner_points_.back().x(); }

 private:
  double CornerHeading(double u) const;
  Eigen::Vector2d IntegrateCorner(double u0, double u1) const;

  double corner_;
  double length_;
  std::vector<Side> sides_;
  std::vector<Eigen::Vector2d> corner_points_;  // a corner every kStep, in the side's frame
};

}  // namespace radive
