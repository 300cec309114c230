// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/terrain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace radive {

Terrain::Terrain(std::vector<Wave> waves) : waves_(std::move(waves)) {
  for (const Wave& wave : waves_) steepest_ += std::abs(wave.amplitude) * wave.wave_vector.norm();
}

double Terrain::Height(const Eigen::Vector2d& p) const {
  double height = 0.0;
  for (const Wave& wave : waves_) {
    height += wave.amplitude * std::sin(wave.wave_vector.dot(p) + wave.phase);
  }
  return height;
}

Terrain::Point Terrain::At(const Eigen::Vector2d& p) const {
  Point point;
  for (const Wave& wave : waves_) {
    const double angle = wave.wave_vector.dot(p) + wave.phase;
    const double sine = wave.amplitude * std::sin(angle);
    point.height += sine;
    point.gradient += wave.amplitude * std::cos(angle) * wave.wave_vector;
    point.hessian -= sine * wave.wave_vector * wave.wave_vector.transpose();
  }
  return point;
}

Eigen::Vector3d Terrain::Normal(const Eigen::Vector2d& p) const {
  if (waves_.empty()) return Eigen::Vector3d::UnitZ();
  const Eigen::Vector2d gradient = At(p).gradient;
  return Eigen::Vector3d(-gradient.x(), -gradient.y(), 1.0).normalized();
}

double Terrain::Cast(const Eigen::Vector3d& origin,
                     const Eigen::Vector3d& direction,
                     double max_distance) const {
  if (waves_.empty()) {
    if (!(direction.z() < 0.0)) return max_distance;
    return std::min(max_distance, -origin.z() / direction.z());
  }
  // Sphere tracing: the ray comes nearer to the ground by at most `approach` a metre, so that it is
  // still above it after clearance / approach metres.
  constexpr double kSmallestStep = 0.05;  // [m]
  const double approach = steepest_ * direction.head<2>().norm() - direction.z();
  if (approach <= 0.0) return max_distance;
  const auto clearance = [&](double distance) {
    const Eigen::Vector3d p = origin + distance * direction;
    return p.z() - Height(p.head<2>());
  };
  double above = 0.0;
  double over = clearance(0.0);
  while (above < max_distance) {
    const double next = above + std::max(over / approach, kSmallestStep);
    over = clearance(next);
    if (over <= 0.0) {
      double below = next;
      while (below - above > 1e-9) {
        const double middle = 0.5 * (above + below);
        (clearance(middle) > 0.0 ? above : below) = middle;
      }
      return std::min(above, max_distance);
    }
    above = next;
  }
  return max_distance;
}

}  // namespace radive
