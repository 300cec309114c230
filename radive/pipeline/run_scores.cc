// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/run_scores.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <system_error>
#include <utility>

#include "radive/evaluation/evaluation_report.h"
#include "radive/io/bytes/record_file.h"
#include "radive/io/trajectories/pose_text.h"
#include "radive/util/angle_units.h"
#include "radive/util/json.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

namespace fs = std::filesystem;
// What run.json says of the trajectory. False when it says nothing usable.
bool ReadRunFacts(const Json& run, RunEstimate* estimate) {
  if (!run.is_object() || !run.contains("start") || !run["start"].is_number_integer()) return false;
  estimate->start = run["start"].get<int>();
  const Json& max_frames = run.value("max_frames", Json());
  estimate->is_partial = run.value("interrupted", Json(false)) == true || !max_frames.is_null();
  const auto trajectory = run.find("trajectory");
  if (trajectory == run.end() || !trajectory->is_object()) return false;
  const auto transform = trajectory->find("T_frame_reference");
  if (transform == trajectory->end() || !transform->is_array() || transform->size() != 7) {
    return false;
  }
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (!(*transform)[i].is_number()) return false;
    v[i] = (*transform)[i].get<double>();
  }
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (!(std::abs(q.norm() - 1.0) < 1e-6) || estimate->start < 0) return false;
  estimate->T_output_reference = Rigid3(q, {v[0], v[1], v[2]});
  return true;
}

// KITTI files with six digits hold matrices that evo does not take for rotations, and so gives no
// angles. What evo takes stays as it is.
void RoundToRotations(RecordedTrajectory* poses) {
  for (RecordedPose& pose : *poses) {
    if (IsRotation(pose.T_world_body.rotation)) continue;
    Eigen::Matrix<double, 3, 4> rows;
    rows << pose.T_world_body.rotation, pose.T_world_body.translation;
    RigidPose(rows, &pose.T_world_body);
  }
}

bool NeedsRotations(const EvaluationOptions& options) {
  return options.metric == EvaluationMetric::kSegments ||
         (options.relation != PoseRelation::kTransPart &&
          options.relation != PoseRelation::kPointDistance &&
          options.relation != PoseRelation::kPointDistanceRatio) ||
         (options.metric == EvaluationMetric::kRpe && options.relation == PoseRelation::kTransPart);
}

std::vector<std::pair<std::string, EvaluationOptions>> ScoreOptions(bool has_rotations) {
  std::vector<std::pair<std::string, EvaluationOptions>> all;
  for (const Plane plane : {Plane::kNone, Plane::kXy}) {
    EvaluationOptions options;
    options.align = AlignmentMode::kSe3;
    options.plane = plane;
    const std::string end = plane == Plane::kNone ? "" : "_xy";
    all.emplace_back("ape_trans" + end, options);
    options.relation = PoseRelation::kAngleDeg;
    if (has_rotations) all.emplace_back("ape_angle" + end, options);
  }
  EvaluationOptions segments;
  segments.metric = EvaluationMetric::kSegments;
  if (has_rotations) all.emplace_back("segments", segments);
  return all;
}

}  // namespace

std::optional<RunEstimate> ReadRunEstimate(const fs::path& path, std::string* error) {
  RunEstimate estimate;
  std::error_code ignored;
  const bool is_folder = fs::is_directory(path, ignored);
  const auto trajectory =
      ReadReference(is_folder ? path / "trajectory_tum.txt" : path, {}, /*clip=*/0, error);
  if (!trajectory) return std::nullopt;
  estimate.poses = trajectory->poses;
  estimate.has_stamps = trajectory->has_stamps;
  estimate.warnings = trajectory->warnings;
  if (!is_folder) return estimate;
  std::string text;
  if (!ReadWholeFile(path / "run.json", &text, error)) return std::nullopt;
  if (ReadRunFacts(ParseJson(text), &estimate)) {
    return estimate;
  }
  *error = (path / "run.json").string() +
           ": expected start and trajectory.T_frame_reference (x y z qx qy qz qw), as "
           "radive_odometry writes them";
  return std::nullopt;
}

bool PrepareComparison(const RunEstimate& estimate,
                       Reference* reference,
                       RecordedTrajectory* poses,
                       EvaluationOptions* options,
                       std::string* error) {
  if (!reference->has_rotations && NeedsRotations(*options)) {
    *error = "the reference has places alone, " + reference->description +
             "; expected metric ape with relation trans_part, or a point_distance";
    return false;
  }
  RoundToRotations(&reference->poses);
  *poses = estimate.poses;
  if (!IsIdentity(estimate.T_output_reference)) {
    const MatrixPose T_output_reference(estimate.T_output_reference);
    for (RecordedPose& pose : *poses) pose.T_world_body = pose.T_world_body * T_output_reference;
  }
  if (reference->has_stamps && estimate.has_stamps) return true;
  options->match = PoseMatch::kLine;
  RecordedTrajectory& all = reference->poses;
  const std::size_t start = std::min(all.size(), static_cast<std::size_t>(estimate.start));
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(start));
  // A whole run has a pose for each line; anything else is an error, and shows as one.
  if (estimate.is_partial && all.size() > poses->size()) all.resize(poses->size());
  return true;
}

std::optional<std::vector<RunScore>> ScoreEstimate(const RunEstimate& estimate,
                                                   const Reference& reference,
                                                   const ReferenceOptions& reference_options,
                                                   std::string* error) {
  std::vector<RunScore> scores;
  for (auto& [name, options] : ScoreOptions(reference.has_rotations)) {
    options.max_time_difference = reference_options.max_time_difference;
    options.max_gap = reference_options.max_gap;
    if (reference_options.interpolate) options.match = PoseMatch::kInterpolate;
    Reference its_reference = reference;
    RecordedTrajectory poses;
    std::string reason;
    if (!PrepareComparison(estimate, &its_reference, &poses, &options, error)) return std::nullopt;
    auto result = Evaluate(its_reference.poses, poses, options, &reason);
    if (result) {
      scores.push_back({name, options, *std::move(result)});
    } else if (options.metric != EvaluationMetric::kSegments) {  // which need 100 m of path
      *error = reason;
      return std::nullopt;
    }
  }
  return scores;
}

std::string ScoresText(const std::vector<RunScore>& scores, const Reference& reference) {
  std::string text = "scores against " + reference.description + "\n";
  for (const RunScore& score : scores) {
    if (score.result.drift) {
      text += FormatText("  %-14s %.4f %% and %.6f deg/m over %zu segments of 100 to 800 m\n",
                         score.name.c_str(),
                         100.0 * score.result.drift->translation,
                         Degrees(score.result.drift->rotation),
                         score.result.drift->segments.size());
    } else {
      text += FormatText("  %-14s %.4f %s (rmse of %d matched poses, aligned se3)\n",
                         score.name.c_str(),
                         score.result.statistics.rmse,
                         score.result.unit.c_str(),
                         score.result.num_matched);
    }
  }
  return text;
}

std::string ScoresJson(const std::vector<RunScore>& scores,
                       const Reference& reference,
                       const std::string& reference_path) {
  Json json;
  json["reference"] = reference_path;
  json["description"] = reference.description;
  for (const RunScore& score : scores) {
    Json entry = ParseJson(EvaluationJson(score.result, score.options));
    for (const char* word : {"align", "plane", "match"}) entry[word] = score.options.Word(word);
    json["scores"][score.name] = std::move(entry);
  }
  return JsonText(json);
}

}  // namespace radive
