// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/score_run.h"

#include "radive/evaluation/angle_units.h"
#include "radive/evaluation/evaluate.h"

namespace radive {
namespace {

std::optional<double> Rmse(const RecordedTrajectory& reference,
                           const RecordedTrajectory& estimate,
                           EvaluationOptions options,
                           EvaluationMetric metric,
                           PoseRelation relation,
                           std::string* error) {
  options.metric = metric;
  options.relation = relation;
  const auto result = Evaluate(reference, estimate, options, error);
  return result ? std::optional<double>(result->statistics.rmse) : std::nullopt;
}

}  // namespace

std::optional<RunScores> ScoreRun(const RecordedTrajectory& reference,
                                  const RecordedTrajectory& estimate,
                                  const EvaluationOptions& options,
                                  std::string* error) {
  const auto rmse = [&](EvaluationMetric metric, PoseRelation relation, std::string* reason) {
    return Rmse(reference, estimate, options, metric, relation, reason);
  };
  RunScores scores;
  scores.ate_t = rmse(EvaluationMetric::kApe, PoseRelation::kTransPart, error);
  scores.ate_r = rmse(EvaluationMetric::kApe, PoseRelation::kAngleDeg, error);
  if (!scores.ate_t || !scores.ate_r) return std::nullopt;
  // A drive shorter than a pair or a segment is no error.
  std::string too_short;
  scores.rpe_t = rmse(EvaluationMetric::kRpe, PoseRelation::kTransPart, &too_short);
  scores.rpe_r = rmse(EvaluationMetric::kRpe, PoseRelation::kAngleDeg, &too_short);
  EvaluationOptions segments = options;
  segments.metric = EvaluationMetric::kSegments;
  if (const auto result = Evaluate(reference, estimate, segments, &too_short)) {
    scores.drift_t = 100.0 * result->drift->translation;
    scores.drift_r = Degrees(result->drift->rotation);
  }
  return scores;
}

}  // namespace radive
