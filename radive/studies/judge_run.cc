// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/judge_run.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "radive/config/yaml_settings.h"
#include "radive/evaluation/path_length.h"
#include "radive/io/open/read_reference.h"
#include "radive/pipeline/run_scores.h"
#include "radive/studies/score_run.h"
#include "radive/util/json.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

// The last thing that the program said, without its name.
std::string LastWords(const std::string& output) {
  std::istringstream lines(output);
  std::string last;
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  const std::string prefix = "radive_odometry: ";
  return last.rfind(prefix, 0) == 0 ? last.substr(prefix.size()) : last;
}

// Status and message of a run that ended badly; false when it ended well.
bool EndedBadly(const Study& study, const RunEnd& end, RunRecord* record) {
  const std::string words = LastWords(end.output);
  const std::string behind = words.empty() ? "" : ": " + words;
  if (end.timed_out) {
    record->status = "timeout";
    record->message = FormatText("not done after %g s", study.timeout);
  } else if (end.signal != 0) {
    record->status = "crashed";
    record->message =
        "signal " + std::to_string(end.signal) + " (" + strsignal(end.signal) + ")" + behind;
  } else if (end.exit_status != 0) {
    record->status = "failed";
    record->message = words.empty() ? "exit status " + std::to_string(end.exit_status) : words;
  } else {
    return false;
  }
  return true;
}

bool ReadCounts(const fs::path& file, RunRecord* record, std::string* error) {
  std::string text;
  if (!ReadTextFile(file.string(), "report of the run", kLargestTable, &text, error)) return false;
  const auto json = ParseJson(text);
  try {
    record->scans = json.at("frames").get<int>();
    record->registered = json.at("status").at("registered").get<int>();
    record->warnings = json.value("num_warnings", 0);
    record->timing.max_rss_mb = json.at("peak_memory_mb").get<double>();
  } catch (const Json::exception& exception) {
    *error = file.string() + ": " + exception.what();
    return false;
  }
  return true;
}

// The smallest value that at least this share of them does not exceed.
double Percentile(const std::vector<double>& sorted, double share) {
  if (sorted.empty()) return 0.0;
  const double rank = std::ceil(share * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

// The column odometry_ms of timing.csv; times that cannot be read stay zero.
void ReadTimes(const fs::path& file, RunTiming* timing) {
  std::string text;
  std::string ignored;
  if (!ReadTextFile(file.string(), "times", kLargestTable, &text, &ignored)) return;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  const std::size_t at = line.find("odometry_ms");
  if (at == std::string::npos) return;
  const auto column = std::count(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(at), ',');
  std::vector<double> times;
  while (std::getline(lines, line)) {
    std::size_t begin = 0;
    for (std::ptrdiff_t i = 0; i < column && begin != std::string::npos; ++i) {
      begin = line.find(',', begin);
      if (begin != std::string::npos) ++begin;
    }
    if (begin == std::string::npos) continue;
    const std::string_view cell =
        std::string_view(line).substr(begin, line.find(',', begin) - begin);
    times.push_back(ParseDouble(cell).value_or(0.0));
  }
  std::sort(times.begin(), times.end());
  timing->ms_per_scan_median = Percentile(times, 0.5);
  timing->ms_per_scan_p95 = Percentile(times, 0.95);
}

// The reference as poses of the body of the estimate, with its stamps where it has none itself.
RecordedTrajectory SeenAsEstimate(const RunEstimate& estimate, Reference reference) {
  RecordedTrajectory poses;
  EvaluationOptions options;  // of the positions alone, which every reference has
  std::string ignored;
  PrepareComparison(estimate, &reference, &poses, &options, &ignored);
  const MatrixPose T_reference_output(estimate.T_output_reference.Inverse());
  if (reference.has_rotations) {
    for (RecordedPose& pose : reference.poses) {
      pose.T_world_body = pose.T_world_body * T_reference_output;
    }
  }
  if (!reference.has_stamps) {
    reference.poses.resize(std::min(reference.poses.size(), poses.size()));
    for (std::size_t i = 0; i < reference.poses.size(); ++i) {
      reference.poses[i].stamp_ns = poses[i].stamp_ns;
      reference.poses[i].stamp_s = poses[i].stamp_s;
    }
  }
  return reference.poses;
}

bool Score(const Study& study,
           const StudyRun& run,
           const fs::path& folder,
           const fs::path& reference_path,
           RecordedTrajectory* reference_poses,
           RunRecord* record,
           std::string* error) {
  const auto estimate = ReadRunEstimate(folder, error);
  if (!estimate) return false;
  std::vector<MatrixPose> poses;
  for (const RecordedPose& pose : estimate->poses) poses.push_back(pose.T_world_body);
  const double path_length = PathLengths(poses).back();
  record->scores.path_length = path_length;
  if (reference_path.empty()) return true;

  const ReferenceOptions& reading = run.config.reference;
  const auto reference = ReadReference(reference_path, reading, run.config.input.clip, error);
  if (!reference) return false;
  EvaluationOptions options = study.evaluation;
  options.max_time_difference = reading.max_time_difference;
  options.max_gap = reading.max_gap;
  if (reading.interpolate) options.match = PoseMatch::kInterpolate;
  const auto scores = ScoreRun(*estimate, *reference, options, error);
  if (!scores) {
    *error = "no score: " + *error;
    return false;
  }
  *reference_poses = SeenAsEstimate(*estimate, *reference);
  record->scores = *scores;
  record->scores.path_length = path_length;
  return true;
}

}  // namespace

void JudgeRun(const Study& study,
              const StudyRun& run,
              const RunEnd& end,
              const fs::path& folder,
              const fs::path& reference_path,
              RecordedTrajectory* reference,
              RunRecord* record) {
  if (EndedBadly(study, end, record)) return;
  record->timing.wall_s = end.wall_s;
  record->timing.cpu_s = end.cpu_s;
  record->timing.max_rss_mb = end.max_rss_mb;
  std::string error;
  if (ReadCounts(folder / "run.json", record, &error) &&
      Score(study, run, folder, reference_path, reference, record, &error)) {
    ReadTimes(folder / "timing.csv", &record->timing);
    record->status = "ok";
    return;
  }
  record->status = "failed";
  record->message = error;
  record->scores = RunScores();
}

}  // namespace radive
