// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "radive/sensor/recorded_trajectory.h"
#include "radive/studies/run_folder.h"
#include "radive/studies/run_record.h"
#include "radive/studies/study_input.h"
#include "radive/studies/study_runs.h"

namespace radive {

// What is known of the runs of a study: their folders, and what could not be written there.
class RunArchive {
 public:
  struct Options {
    std::filesystem::path output;
    std::string program_hash;
    KeptFiles kept = KeptFiles::kAll;
    bool retry = true;  // runs that failed are not complete
  };
  explicit RunArchive(Options options) : options_(std::move(options)) {}

  // Names and hashes of a run that is yet to be done.
  RunRecord NewRecord(const StudyRun& run,
                      const std::string& input_hash,
                      const std::string& config_hash) const;

  // True when the folder of the run has a record with the hashes of `record`, which becomes it.
  bool IsComplete(const StudyRun& run, RunRecord* record) const;

  // The same for an input that is not there: whatever its hash was, the result is kept.
  bool IsCompleteWithoutInput(const StudyRun& run, RunRecord* record) const;

  // Records what became of a run in its folder, whose lock the caller holds. When that fails, on a
  // full disk say, the record is kept here, as that of a run that failed.
  void Save(const StudyRun& run,
            const std::filesystem::path& reference_path,
            const RecordedTrajectory& reference,
            const std::string& log,
            RunRecord* record);

  // A record that has no folder.
  void KeepUnsaved(const RunRecord& record) { unsaved_.push_back(record); }
  const std::vector<RunRecord>& unsaved() const { return unsaved_; }

 private:
  const Options options_;
  std::vector<RunRecord> unsaved_;
};

}  // namespace radive
