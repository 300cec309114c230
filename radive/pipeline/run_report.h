// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "radive/config/run_config.h"
#include "radive/geometry/rigid3.h"
#include "radive/odometry/odometry_result.h"

namespace radive {

// Counts of a run and what is worth telling about it; becomes run.json. Its size does not grow
// with the drive, but for four bytes a scan that the 95th percentile needs.
class RunReport {
 public:
  // `place` of the scan: where it was read.
  void AddScan(const OdometryResult& result, double read_ms, const std::string& place);

  // Remarks about the data. Only the first ones are kept, all are counted.
  void AddWarning(const std::string& warning);
  void AddNote(const std::string& note);

  int num_scans() const { return static_cast<int>(odometry_ms_.size()); }
  int num_with_status(OdometryResult::Status status) const;

  // Why the poses are no result: no scan was registered with an earlier one or found standing. Says
  // the commonest reason, the first scan that has it, and the first warning. Empty when some were,
  // and for a drive of one scan that started the submap.
  std::string WhyNoResult() const;

  // The facts that the loop does not count.
  struct Facts {
    std::string version;
    std::string command_line;
    std::string input;
    std::string source;  // its description
    int start = 0;
    std::optional<int> max_frames;  // that were asked for; none: all
    Rigid3 T_frame_reference;       // of output.frame and the ground truth's body
    bool interrupted = false;
    std::string error;  // why the run ended early; empty when it did not
    double wall_seconds = 0.0;
  };
  std::string ToJson(const RunConfig& config, const Facts& facts) const;

 private:
  std::map<std::string, int> statuses_;
  std::map<std::string, std::map<std::string, int>> reasons_;  // status -> reason -> scans
  std::size_t num_reasons_ = 0;
  struct FirstReason {
    int count = 0;
    std::string text, place;  // of the first scan
  };
  std::map<std::string, FirstReason> kinds_;  // of reasons: without their numbers
  int num_located_ = 0;                       // registered with an earlier scan, or standing
  std::vector<std::string> warnings_;
  int num_warnings_ = 0;
  std::vector<std::string> notes_;
  std::vector<float> odometry_ms_;
  double read_ms_ = 0.0;
};

}  // namespace radive
