// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/score_run.h"

#include "radive/evaluation/evaluate.h"
#include "radive/util/angle_units.h"

namespace radive {
namespace {

std::optional<EvaluationResult> Measure(const RunEstimate& estimate,
                                        Reference reference,
                                        EvaluationOptions options,
                                        EvaluationMetric metric,
                                        PoseRelation relation,
                                        std::string* error) {
  options.metric = metric;
  options.relation = relation;
  RecordedTrajectory poses;
  if (!PrepareComparison(estimate, &reference, &poses, &options, error)) return std::nullopt;
  return Evaluate(reference.poses, poses, options, error);
}

}  // namespace

std::optional<RunScores> ScoreRun(const RunEstimate& estimate,
                                  const Reference& reference,
                                  const EvaluationOptions& options,
                                  std::string* error) {
  const auto rmse = [&](EvaluationMetric metric, PoseRelation relation, std::string* reason) {
    const auto result = Measure(estimate, reference, options, metric, relation, reason);
    return result ? std::optional<double>(result->statistics.rmse) : std::nullopt;
  };
  RunScores scores;
  scores.ate_t = rmse(EvaluationMetric::kApe, PoseRelation::kTransPart, error);
  if (!scores.ate_t) return std::nullopt;
  if (!reference.has_rotations) return scores;
  scores.ate_r = rmse(EvaluationMetric::kApe, PoseRelation::kAngleDeg, error);
  if (!scores.ate_r) return std::nullopt;
  // A drive shorter than a pair or a segment is no error.
  std::string too_short;
  scores.rpe_t = rmse(EvaluationMetric::kRpe, PoseRelation::kTransPart, &too_short);
  scores.rpe_r = rmse(EvaluationMetric::kRpe, PoseRelation::kAngleDeg, &too_short);
  const auto segments = Measure(estimate,
                                reference,
                                options,
                                EvaluationMetric::kSegments,
                                PoseRelation::kTransPart,
                                &too_short);
  if (segments) {
    scores.drift_t = 100.0 * segments->drift->translation;
    scores.drift_r = Degrees(segments->drift->rotation);
  }
  return scores;
}

}  // namespace radive
