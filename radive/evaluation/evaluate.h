// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radive/evaluation/alignment.h"
#include "radive/evaluation/error_statistics.h"
#include "radive/evaluation/evaluation_options.h"
#include "radive/evaluation/segment_drift.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive {

struct EvaluationResult {
  int num_reference = 0;  // poses given
  int num_estimate = 0;
  int num_matched = 0;  // pairs of poses that belong together

  Alignment alignment;  // applied to the estimate

  // One error for each matched pose (ape), pair of poses (rpe) or segment (its translation error
  // in per cent), in order of the trajectory, in `unit`.
  std::vector<double> errors;
  std::string unit;
  ErrorStatistics statistics;

  std::optional<SegmentDrift> drift;  // metric segments only

  // What makes the figures doubtful: poses of the estimate without a counterpart.
  std::vector<std::string> warnings;
};

// Compares two trajectories as evo does: match, align the estimate, project both, measure.
// std::nullopt, with the reason in `error`, for invalid options and for trajectories that do not
// allow the evaluation asked for.
std::optional<EvaluationResult> Evaluate(const RecordedTrajectory& reference,
                                         const RecordedTrajectory& estimate,
                                         const EvaluationOptions& options,
                                         std::string* error);

}  // namespace radive
