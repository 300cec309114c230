// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace radive {

// Errors of a trajectory, those of radive_evaluate. A drive without reference has none; one under
// 100 m has no segments to drift over.
struct RunScores {
  std::optional<double> ate_t;        // RMSE of the positions [m]
  std::optional<double> ate_r;        // RMSE of the rotation angles [deg]
  std::optional<double> rpe_t;        // RMSE of the relative positions [m]
  std::optional<double> rpe_r;        // RMSE of the relative rotation angles [deg]
  std::optional<double> drift_t;      // of segments as KITTI has them [%]
  std::optional<double> drift_r;      // [deg/m]
  std::optional<double> path_length;  // of the estimate [m]
};

// How long a run took. No result depends on it.
struct RunTiming {
  double wall_s = 0.0;
  double cpu_s = 0.0;
  double ms_per_scan_median = 0.0;
  double ms_per_scan_p95 = 0.0;
  double max_rss_mb = 0.0;  // [MB = 1e6 bytes]
};

// What became of a run: a row of results.csv, and one of timings.csv.
struct RunRecord {
  std::string sequence;
  std::string variant;
  int seed = 0;
  std::string status;   // ok | failed | crashed | timeout | absent
  std::string message;  // why not ok
  RunScores scores;
  std::optional<int> scans;
  std::optional<int> registered;
  std::optional<int> warnings;  // nothing in records of versions that did not count them
  std::string input_hash;
  std::string config_hash;
  std::string program_hash;

  RunTiming timing;

  // True when both would come from the same input, settings and program.
  bool HasHashesOf(const RunRecord& other) const;
};

// Sequence, then variant, then seed.
bool operator<(const RunRecord& a, const RunRecord& b);

// The key "batch" of run.json.
nlohmann::ordered_json RunRecordToJson(const RunRecord& record);

// Nothing when `json` is no such record.
std::optional<RunRecord> RunRecordFromJson(const nlohmann::ordered_json& json);

}  // namespace radive
