// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "radive/evaluation/evaluate.h"
#include "radive/geometry/rigid3.h"
#include "radive/io/open/read_reference.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// An estimated trajectory, and what is known of it besides its file.
struct RunEstimate {
  RecordedTrajectory poses;  // T_world_output
  bool has_stamps = true;
  int start = 0;              // scans of the drive before the first pose
  bool is_partial = false;    // the run was told to end before the drive
  Rigid3 T_output_reference;  // where the ground truth's body is, seen from the trajectory's
  std::vector<std::string> warnings;  // what is odd about the poses
};

// Reads the trajectory of a results folder, with what its run.json says, or a trajectory file.
// Nothing, with the reason in `error`, when that fails.
std::optional<RunEstimate> ReadRunEstimate(const std::filesystem::path& path, std::string* error);

// Makes the two comparable: poses of the estimate become those of the reference's body,
// T_world_output * T_output_reference. Without stamps poses are matched by line: that is set in
// `options`, and of the reference the lines are left whose scans were run over. Matrices of the
// reference that are rotations but for rounding are made rotations. False, with the
// reason in `error`, when the reference has places alone and `options` ask for rotations.
bool PrepareComparison(const RunEstimate& estimate,
                       Reference* reference,
                       RecordedTrajectory* poses,
                       EvaluationOptions* options,
                       std::string* error);

// One line of the scores of a run.
struct RunScore {
  std::string name;  // "ape_trans", "ape_angle", "ape_trans_xy", "ape_angle_xy", "segments"
  EvaluationOptions options;
  EvaluationResult result;
};

// The scores of a run: absolute pose errors after alignment (se3), as they are and in the xy plane,
// and the drift over segments where the drive is long enough; the same numbers that Evaluate()
// gives with the options of each. Nothing, with the reason in `error`, when the trajectories cannot
// be compared.
std::optional<std::vector<RunScore>> ScoreEstimate(const RunEstimate& estimate,
                                                   const Reference& reference,
                                                   const ReferenceOptions& options,
                                                   std::string* error);

// For people, a line a score; and scores.json.
std::string ScoresText(const std::vector<RunScore>& scores, const Reference& reference);
std::string ScoresJson(const std::vector<RunScore>& scores,
                       const Reference& reference,
                       const std::string& reference_path);

}  // namespace radive
