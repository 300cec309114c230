// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/velocity_ransac.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "radive/geometry/plane_basis.h"
#include "radive/kernels/kernels.h"

namespace radive {
namespace {

// Determinant of two horizontal directions, about the sine of the angle between them, or of three
// directions, below which they do not tell the velocity: Doppler noise would be amplified fifty
// times.
constexpr double kMinDeterminant = 0.02;

// `columns`: in the basis that the velocity has.
template <typename Velocity>
int CountInliers(const DopplerColumns& columns, const Velocity& velocity, double gate) {
  return ActiveKernels().count_within_gate(columns, velocity.data(), gate);
}

}  // namespace

DopplerEquations MakeDopplerEquations(const std::vector<RadarReturn>& returns,
                                      const Eigen::Vector3d& up_radar,
                                      double span) {
  DopplerEquations equations;
  equations.span = span;
  equations.basis = PlaneBasis(up_radar);
  const auto capacity = static_cast<Eigen::Index>(returns.size());
  for (Eigen::ArrayXd* column :
       {&equations.x, &equations.y, &equations.z, &equations.v_doppler, &equations.range}) {
    column->resize(capacity);
  }
  Eigen::Index n = 0;
  for (const RadarReturn& entry : returns) {
    const double range = entry.position.norm();
    if (!(range > 0.0) || !std::isfinite(range) || !std::isfinite(entry.doppler)) continue;
    equations.x[n] = entry.position.x() / range;
    equations.y[n] = entry.position.y() / range;
    equations.z[n] = entry.position.z() / range;
    equations.v_doppler[n] = entry.doppler;
    equations.range[n] = range;
    ++n;
  }
  for (Eigen::ArrayXd* column :
       {&equations.x, &equations.y, &equations.z, &equations.v_doppler, &equations.range}) {
    column->conservativeResize(n);
  }
  const Eigen::Matrix<double, 3, 2>& basis = equations.basis;
  equations.first =
      equations.x * basis(0, 0) + equations.y * basis(1, 0) + equations.z * basis(2, 0);
  equations.second =
      equations.x * basis(0, 1) + equations.y * basis(1, 1) + equations.z * basis(2, 1);
  return equations;
}

std::optional<VelocityHypothesis> DrawVelocity(const DopplerEquations& equations,
                                               double gate,
                                               int num_draws,
                                               const std::optional<VelocityGate>& temporal_gate,
                                               Random* random) {
  std::optional<VelocityHypothesis> best;
  DopplerColumns columns = equations.Columns();
  columns.direction[0] = equations.first.data();
  columns.direction[1] = equations.second.data();
  columns.direction[2] = nullptr;
  const auto consider = [&](const Eigen::Vector2d& velocity) {
    const int num_inliers = CountInliers(columns, velocity, gate);
    if (!best || num_inliers > best->num_inliers) best = {velocity, num_inliers};
  };
  if (temporal_gate) consider(temporal_gate->center);
  if (equations.size() < 2) return best;
  const auto size = static_cast<std::uint64_t>(equations.size());
  for (int draw = 0; draw < num_draws; ++draw) {
    const auto i = static_cast<Eigen::Index>(random->Index(size));
    const auto j = static_cast<Eigen::Index>(random->Index(size));
    const double a = equations.first[i], b = equations.second[i];
    const double c = equations.first[j], d = equations.second[j];
    const double determinant = a * d - b * c;
    if (!(std::abs(determinant) > kMinDeterminant)) continue;
    const double r = -equations.v_doppler[i], s = -equations.v_doppler[j];
    const Eigen::Vector2d velocity = Eigen::Vector2d(d * r - b * s, a * s - c * r) / determinant;
    if (temporal_gate && !temporal_gate->Contains(velocity)) continue;
    consider(velocity);
  }
  return best;
}

std::optional<Eigen::Vector3d> DrawSpatialVelocity(const DopplerEquations& equations,
                                                   double gate,
                                                   int num_draws,
                                                   const std::optional<VelocityGate>& temporal_gate,
                                                   Random* random) {
  std::optional<Eigen::Vector3d> best;
  int most_inliers = 0;
  const DopplerColumns columns = equations.Columns();
  if (equations.size() < 3) return best;
  const auto size = static_cast<std::uint64_t>(equations.size());
  for (int draw = 0; draw < num_draws; ++draw) {
    Eigen::Matrix3d directions;
    Eigen::Vector3d v_doppler;
    for (int row = 0; row < 3; ++row) {
      const auto i = static_cast<Eigen::Index>(random->Index(size));
      directions.row(row) = equations.Direction(i);
      v_doppler[row] = equations.v_doppler[i];
    }
    if (!(std::abs(directions.determinant()) > kMinDeterminant)) continue;
    const Eigen::Vector3d velocity = -directions.inverse() * v_doppler;
    if (temporal_gate && !temporal_gate->Contains(equations.basis.transpose() * velocity)) continue;
    const int num_inliers = CountInliers(columns, velocity, gate);
    if (best && num_inliers <= most_inliers) continue;
    best = velocity;
    most_inliers = num_inliers;
  }
  return best;
}

}  // namespace radive
