// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "radive/ego_velocity/velocity_ransac.h"
#include "radive/util/random.h"

namespace radive {

struct VelocityBranch {
  VelocityHypothesis hypothesis;

  // Almost as many returns agree with another velocity as well, one that lies further away than
  // half a span: the scan leaves open which multiple of the span is the true one.
  bool is_ambiguous = false;
};

// DrawVelocity() for Doppler that wraps, equations.span > 0. Two returns tell the velocity only
// when their multiples of the span are known, and near a given velocity they are: the draws are
// repeated around places in steps of half a span along `forward` (unit, in the basis of the
// equations), to both sides of the temporal gate's center as far as the gate reaches, or, without
// one, of zero up to `max_speed` [m/s]. Returns that lie in different directions wrap differently,
// so most of them agree on the true velocity alone. None when no draw gives a hypothesis.
std::optional<VelocityBranch> DrawVelocityBranch(const DopplerEquations& equations,
                                                 double gate,
                                                 int num_draws,
                                                 const std::optional<VelocityGate>& temporal_gate,
                                                 const Eigen::Vector2d& forward,
                                                 double max_speed,
                                                 Random* random);

}  // namespace radive
