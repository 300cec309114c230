// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/street_path.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "radive/util/angle_units.h"

namespace radive {
namespace {

constexpr int kCornerSteps = 32;  // pieces of a corner; five-point Gauss is then exact to 1e-12 m

}  // namespace

StreetPath::StreetPath(double long_side, double short_side, double corner)
    : corner_(corner), length_(2.0 * (long_side + short_side) + 4.0 * corner) {
  CHECK_GT(long_side, 0.0);
  CHECK_GT(short_side, 0.0);
  CHECK_GT(corner, 0.0);
  corner_points_.push_back(Eigen::Vector2d::Zero());
  for (int i = 0; i < kCornerSteps; ++i) {
    const double step = corner / kCornerSteps;
    corner_points_.push_back(corner_points_.back() + IntegrateCorner(i * step, (i + 1) * step));
  }
  Side side;
  for (int i = 0; i < kNumSides; ++i) {
    side.straight = i % 2 == 0 ? long_side : short_side;
    sides_.push_back(side);
    side.origin = side.ToWorld(side.straight + corner_reach(), corner_points_.back().y());
    // Exact quarter turns, so that the loop closes exactly.
    const Eigen::Vector2d along = side.along;
    side.along = side.left;
    side.left = -along;
    side.start_s += side.straight + corner;
  }
}

StreetPath::Point StreetPath::At(double s) const {
  s = std::fmod(s, length_);
  if (s < 0.0) s += length_;
  std::size_t i = kNumSides - 1;
  while (sides_[i].start_s > s) --i;
  const Side& side = sides_[i];
  const double x = s - side.start_s;
  Point point;
  point.heading = static_cast<double>(i) * 0.5 * kPi;
  if (x <= side.straight) {
    point.position = side.ToWorld(x, 0.0);
    return point;
  }
  const double u = std::min(x - side.straight, corner_);
  const double step = corner_ / kCornerSteps;
  const int piece = std::min(static_cast<int>(u / step), kCornerSteps - 1);
  const Eigen::Vector2d local =
      corner_points_[static_cast<std::size_t>(piece)] + IntegrateCorner(piece * step, u);
  point.position = side.ToWorld(side.straight + local.x(), local.y());
  point.heading += CornerHeading(u);
  point.curvature = 0.5 * kPi / corner_ * (1.0 - std::cos(2.0 * kPi * u / corner_));
  return point;
}

double StreetPath::CornerHeading(double u) const {
  return 0.5 * kPi * (u / corner_ - std::sin(2.0 * kPi * u / corner_) / (2.0 * kPi));
}

// Displacement between two arc lengths of a corner: Gauss-Legendre quadrature of the tangent.
Eigen::Vector2d StreetPath::IntegrateCorner(double u0, double u1) const {
  constexpr double kNodes[] = {
      0.0, -0.5384693101056831, 0.5384693101056831, -0.9061798459386640, 0.9061798459386640};
  constexpr double kWeights[] = {0.5688888888888889,
                                 0.4786286704993665,
                                 0.4786286704993665,
                                 0.2369268850561891,
                                 0.2369268850561891};
  const double half = 0.5 * (u1 - u0);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int i = 0; i < 5; ++i) {
    const double heading = CornerHeading(u0 + half * (1.0 + kNodes[i]));
    sum += kWeights[i] * Eigen::Vector2d(std::cos(heading), std::sin(heading));
  }
  return half * sum;
}

}  // namespace radive
