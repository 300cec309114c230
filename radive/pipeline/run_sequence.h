// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <optional>
#include <string>

#include "radive/config/run_config.h"
#include "radive/io/scans/scan_source.h"

namespace radive {

// What a run is asked for besides its configuration.
struct RunRequest {
  std::string input;                        // as the user named it, for run.json
  std::string output;                       // results folder, see ResultWriter
  std::string reference;                    // ground truth to score against; empty: none
  int start = 0;                            // scans left out at the beginning
  std::optional<int> num_frames;            // scans to run over; none: all
  bool quiet = false;                       // no progress and remarks on stderr
  std::string command_line;                 // for run.json
  std::string version;                      // for run.json
  const std::atomic<bool>* stop = nullptr;  // becomes true: finish the scan at hand and the files
};

enum class RunStatus {
  kDone,         // to the end of the drive
  kInterrupted,  // by `stop`; the files are whole
  kNoResult,     // to the end, but no scan was registered or found standing: see the error
  kFailed        // see the error; what was estimated before is in the files all the same
};

// Runs the odometry over the scans of `source` and writes the results folder. With a ground truth
// the scores go to scores.json in it, and as text to `scores`, where that is not null.
RunStatus RunSequence(const RunConfig& config,
                      const RunRequest& request,
                      ScanSource* source,
                      std::string* error,
                      std::string* scores = nullptr);

}  // namespace radive
