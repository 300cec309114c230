// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include "radive/sensor/recorded_trajectory.h"
#include "radive/studies/run_record.h"
#include "radive/studies/study_runs.h"

namespace radive {

// How the process of a run ended.
struct RunEnd {
  int exit_status = 0;
  int signal = 0;  // that ended it; 0: none
  bool timed_out = false;
  std::string output;
  double wall_s = 0.0;
  double cpu_s = 0.0;
  double max_rss_mb = 0.0;
};

// Fills in what became of a run from its end and from the files in `folder`: status, message,
// counts, scores and times. `reference_path` is empty for a drive that is not scored; its poses go
// to `reference`, as those of the body whose trajectory was estimated.
void JudgeRun(const Study& study,
              const StudyRun& run,
              const RunEnd& end,
              const std::filesystem::path& folder,
              const std::filesystem::path& reference_path,
              RecordedTrajectory* reference,
              RunRecord* record);

}  // namespace radive
