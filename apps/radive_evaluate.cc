// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "app_main.h"
#include "radive/evaluation/evaluate.h"
#include "radive/evaluation/evaluation_report.h"
#include "radive/io/open/read_reference.h"
#include "radive/pipeline/run_scores.h"

DEFINE_string(reference,
              "",
              "Trajectory that counts as true: a file, or a dataset's folder. Required.");
DEFINE_string(estimate,
              "",
              "Trajectory to be judged: a TUM or KITTI file, or a folder with the results of "
              "radive_odometry, whose poses become those of the reference's body. Required.");
DEFINE_string(format,
              "auto",
              "Form of the reference: auto | tum | kitti | euroc | table | vod | radarscenes | "
              "coloradar | boreas | dicp | raflow | bag.");
DEFINE_string(topic, "", "Topic with the poses, of a reference in a bag; empty: the only one.");
DEFINE_int32(clip, 0, "Which clip, of a reference in RaFlow's files; 0: the longest.");
DEFINE_string(metric, "ape", "ape | rpe | segments (drift over 100 to 800 m, as KITTI has it).");
DEFINE_string(relation,
              "trans_part",
              "trans_part | angle_deg | angle_rad | rot_part | full | point_distance | "
              "point_distance_ratio: what of a pose difference counts.");
DEFINE_string(align, "none", "none | se3 | sim3 | scale_only | origin.");
DEFINE_int32(align_first, 0, "Align with the first N matched poses; 0: all.");
DEFINE_string(plane, "none", "none | xy | xz | yz: project both trajectories after the alignment.");
DEFINE_double(delta, 1.0, "Distance of the two poses of an rpe pair, in --delta_unit.");
DEFINE_string(delta_unit, "f", "f (frames) | m (metres of path) | deg | rad.");
DEFINE_bool(all_pairs, false, "Every pose starts an rpe pair, instead of one after the other.");
DEFINE_bool(pairs_from_reference, false, "Choose rpe pairs on the reference, not the estimate.");
DEFINE_double(max_time_difference, 0.01, "Largest difference of matched stamps [s].");
DEFINE_bool(interpolate,
            false,
            "Bring the reference to the stamps of the estimate, which evo does not do.");
DEFINE_double(max_gap, 1.0, "Longest interval of the reference to interpolate in [s].");
DEFINE_bool(json, false, "Print one JSON object instead of a table.");

namespace {

constexpr char kUsage[] =
    "Errors of an estimated trajectory against a reference, defined as in evo.\n"
    "  radive_evaluate --reference=GROUND_TRUTH --estimate=RESULTS/trajectory_tum.txt --align=se3\n"
    "  radive_evaluate --reference=R --estimate=E --metric=rpe --delta=100 --delta_unit=m";

bool ReadFlags(radive::EvaluationOptions* options, std::string* error) {
  options->max_time_difference = FLAGS_max_time_difference;
  options->max_gap = FLAGS_max_gap;
  options->align_first = FLAGS_align_first;
  options->pairs.delta = FLAGS_delta;
  options->pairs.all_pairs = FLAGS_all_pairs;
  options->pairs_from_reference = FLAGS_pairs_from_reference;
  if (FLAGS_reference.empty() || FLAGS_estimate.empty()) {
    *error = "--reference and --estimate are required; see --help";
    return false;
  }
  if (FLAGS_interpolate) options->match = radive::PoseMatch::kInterpolate;
  return options->SetWord("metric", FLAGS_metric, error) &&
         options->SetWord("relation", FLAGS_relation, error) &&
         options->SetWord("align", FLAGS_align, error) &&
         options->SetWord("plane", FLAGS_plane, error) &&
         options->SetWord("delta_unit", FLAGS_delta_unit, error);
}

std::optional<radive::Reference> ReadItsReference(std::string* error) {
  radive::ReferenceOptions options;
  const std::vector<std::string>& names = radive::ReferenceFormatNames();
  const auto name = std::find(names.begin(), names.end(), FLAGS_format);
  if (name == names.end()) {
    *error = "--format must be one of";
    for (const std::string& one : names) *error += (one == names[0] ? " " : " | ") + one;
    *error += ", is '" + FLAGS_format + "'";
    return std::nullopt;
  }
  options.format = static_cast<radive::ReferenceOptions::Format>(name - names.begin());
  options.topic = FLAGS_topic;
  return radive::ReadReference(FLAGS_reference, options, FLAGS_clip, error);
}

bool Run(std::string* error) {
  radive::EvaluationOptions options;
  if (!ReadFlags(&options, error)) return false;
  auto reference = ReadItsReference(error);
  if (!reference) return false;
  const auto estimate = radive::ReadRunEstimate(FLAGS_estimate, error);
  if (!estimate) return false;
  radive::RecordedTrajectory poses;
  if (!radive::PrepareComparison(*estimate, &*reference, &poses, &options, error)) return false;
  auto result = radive::Evaluate(reference->poses, poses, options, error);
  if (!result) return false;
  for (const auto& of_file : {estimate->warnings, reference->warnings}) {
    result->warnings.insert(result->warnings.begin(), of_file.begin(), of_file.end());
  }
  for (const std::string& warning : result->warnings) {
    std::fprintf(stderr, "radive_evaluate: warning: %s\n", warning.c_str());
  }
  const std::string report = FLAGS_json ? radive::EvaluationJson(*result, options)
                                        : radive::EvaluationTable(*result, options);
  std::fputs(report.c_str(), stdout);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  radive::InitApp(&argc, &argv, kUsage);
  std::string error;
  if (!Run(&error)) {
    std::fprintf(stderr, "radive_evaluate: %s\n", error.c_str());
    return radive::EndApp(radive::ExitStatus::kFailure);
  }
  return radive::EndApp(radive::ExitStatus::kSuccess);
}
