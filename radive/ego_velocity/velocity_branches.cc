// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/velocity_branches.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace radive {
namespace {

// Share of the best velocity's returns with which another one leaves the branch open.
constexpr double kAmbiguousShare = 0.9;

// The same equations, with the Doppler of each return nearest to that of a velocity.
DopplerEquations UnwrappedAround(const DopplerEquations& equations,
                                 const Eigen::Vector2d& velocity) {
  DopplerEquations unwrapped = equations;
  const Eigen::ArrayXd expected =
      -(equations.first * velocity.x() + equations.second * velocity.y());
  const Eigen::ArrayXd difference = equations.v_doppler - expected;
  unwrapped.v_doppler =
      expected + difference - equations.span * (difference / equations.span).round();
  return unwrapped;
}

}  // namespace

std::optional<VelocityBranch> DrawVelocityBranch(const DopplerEquations& equations,
                                                 double gate,
                                                 int num_draws,
                                                 const std::optional<VelocityGate>& temporal_gate,
                                                 const Eigen::Vector2d& forward,
                                                 double max_speed,
                                                 Random* random) {
  CHECK_GT(equations.span, 0.0);
  const double step = 0.5 * equations.span;
  const Eigen::Vector2d center = temporal_gate ? temporal_gate->center : Eigen::Vector2d::Zero();
  const double reach = std::min(temporal_gate ? temporal_gate->radius : max_speed, max_speed);
  const int num_steps = static_cast<int>(std::ceil(reach / step));
  std::vector<VelocityHypothesis> candidates;
  for (int k = -num_steps; k <= num_steps; ++k) {
    const Eigen::Vector2d around = center + k * step * forward;
    const std::optional<VelocityHypothesis> hypothesis =
        DrawVelocity(UnwrappedAround(equations, around), gate, num_draws, temporal_gate, random);
    if (hypothesis) candidates.push_back(*hypothesis);
  }
  if (candidates.empty()) return std::nullopt;
  VelocityBranch branch;
  branch.hypothesis =
      *std::max_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return a.num_inliers < b.num_inliers;
      });
  branch.is_ambiguous =
      std::any_of(candidates.begin(), candidates.end(), [&](const VelocityHypothesis& other) {
        return (other.velocity - branch.hypothesis.velocity).norm() > step &&
               other.num_inliers >= kAmbiguousShare * branch.hypothesis.num_inliers;
      });
  return branch;
}

}  // namespace radive
