// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/evaluate.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "radive/evaluation/absolute_pose_error.h"
#include "radive/evaluation/association.h"
#include "radive/evaluation/path_length.h"
#include "radive/evaluation/relative_pose_error.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

// Every tenth pose starts a segment, as in the KITTI benchmark.
constexpr int kSegmentStep = 10;

std::optional<MatchedPoses> Associate(const RecordedTrajectory& reference,
                                      const RecordedTrajectory& estimate,
                                      const EvaluationOptions& options,
                                      std::string* error) {
  switch (options.match) {
    case PoseMatch::kLine:
      return AssociateByIndex(reference, estimate, error);
    case PoseMatch::kInterpolate:
      return AssociateInterpolated(reference, estimate, options.max_gap, error);
    case PoseMatch::kStamp:
      break;
  }
  return AssociateByStamp(reference, estimate, options.max_time_difference, error);
}

std::optional<std::vector<double>> MeasureRelative(const MatchedPoses& poses,
                                                   const EvaluationOptions& options,
                                                   std::string* error) {
  const auto pairs = SelectPosePairs(
      options.pairs_from_reference ? poses.reference : poses.estimate, options.pairs, error);
  return pairs ? RelativePoseErrors(poses, *pairs, options.relation, error) : std::nullopt;
}

// Fills errors, unit and drift.
bool Measure(const MatchedPoses& poses,
             const EvaluationOptions& options,
             EvaluationResult* result,
             std::string* error) {
  if (options.metric == EvaluationMetric::kSegments) {
    result->drift = ComputeSegmentDrift(poses, kSegmentStep, error);
    if (!result->drift) return false;
    for (const SegmentError& segment : result->drift->segments) {
      result->errors.push_back(100.0 * segment.translation);
    }
    result->unit = "%";
    return true;
  }
  std::optional<std::vector<double>> errors =
      options.metric == EvaluationMetric::kApe ? AbsolutePoseErrors(poses, options.relation, error)
                                               : MeasureRelative(poses, options, error);
  if (!errors) return false;
  result->errors = *std::move(errors);
  result->unit = UnitOf(options.relation);
  return true;
}

// Poses before and after the reference need no counterpart, as long as most others are matched.
std::optional<std::string> UnmatchedPoses(const RecordedTrajectory& reference,
                                          const RecordedTrajectory& estimate,
                                          const EvaluationOptions& options,
                                          std::size_t num_matched) {
  if (options.match == PoseMatch::kLine) return std::nullopt;
  const auto is_earlier = [](const RecordedPose& a, const RecordedPose& b) {
    return a.stamp_s < b.stamp_s;
  };
  const auto [first, last] = std::minmax_element(reference.begin(), reference.end(), is_earlier);
  const auto is_within = [begin = first->stamp_s, end = last->stamp_s](const RecordedPose& pose) {
    return pose.stamp_s >= begin && pose.stamp_s <= end;
  };
  const auto num_within =
      static_cast<std::size_t>(std::count_if(estimate.begin(), estimate.end(), is_within));
  const bool are_most_matched = 2 * num_matched > estimate.size();
  const std::size_t num_wanted = are_most_matched ? num_within : estimate.size();
  if (num_matched >= num_wanted) return std::nullopt;
  return std::to_string(num_wanted - num_matched) + " of " + std::to_string(estimate.size()) +
         " poses of the estimate have no counterpart in the reference" +
         (are_most_matched ? ", in the time that it covers" : "");
}

// Behind the alignment: a wrong unit, where that does not scale. Also of a drive that is lost.
std::optional<std::string> DifferentLengths(const MatchedPoses& poses) {
  constexpr double kShortest = 5.0;  // [m]
  constexpr double kLargestRatio = 5.0;
  const double reference = PathLengths(poses.reference).back();
  const double estimate = PathLengths(poses.estimate).back();
  const double ratio = estimate / reference;
  if (std::max(reference, estimate) < kShortest ||
      (ratio < kLargestRatio && ratio > 1.0 / kLargestRatio)) {
    return std::nullopt;
  }
  return FormatText(
      "the path of the estimate is %.4g m long, that of the reference %.4g m: are both in metres?",
      estimate,
      reference);
}

}  // namespace

std::optional<EvaluationResult> Evaluate(const RecordedTrajectory& reference,
                                         const RecordedTrajectory& estimate,
                                         const EvaluationOptions& options,
                                         std::string* error) {
  if (!options.IsValid(error)) return std::nullopt;
  std::optional<MatchedPoses> poses = Associate(reference, estimate, options, error);
  if (!poses) return std::nullopt;

  const std::optional<Alignment> alignment = ComputeAlignment(
      options.align, poses->reference, poses->estimate, options.align_first, error);
  if (!alignment) return std::nullopt;
  ApplyAlignment(*alignment, &poses->estimate);
  ProjectToPlane(options.plane, &poses->reference);
  ProjectToPlane(options.plane, &poses->estimate);

  EvaluationResult result;
  result.num_reference = static_cast<int>(reference.size());
  result.num_estimate = static_cast<int>(estimate.size());
  result.num_matched = static_cast<int>(poses->reference.size());
  result.alignment = *alignment;
  if (auto doubt = UnmatchedPoses(reference, estimate, options, poses->reference.size())) {
    result.warnings.push_back(*std::move(doubt));
  }
  if (auto doubt = DifferentLengths(*poses)) result.warnings.push_back(*std::move(doubt));
  if (!Measure(*poses, options, &result, error)) return std::nullopt;
  result.statistics = ComputeErrorStatistics(result.errors);
  return result;
}

}  // namespace radive
