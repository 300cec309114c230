// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "radive/sensor/recorded_trajectory.h"
#include "radive/studies/run_record.h"
#include "radive/studies/study_runs.h"

namespace radive {

// What the folder of a finished run keeps.
enum class KeptFiles {
  kAll,
  kTrajectories,  // trajectories, run.json, config.yaml, log.txt
  kScores         // the last three
};

// The folder OUTPUT/runs/SEQUENCE/VARIANT/SEED of a run. It appears whole, in one step, when the
// run has ended: until then it is called .SEED.partial, which only the process with LockFile() may
// touch.
class RunFolder {
 public:
  RunFolder(const std::filesystem::path& output, const StudyRun& run);

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& partial() const { return partial_; }
  const std::filesystem::path& LockFile() const { return lock_; }

  // The record of an ended run; nothing when there is none.
  std::optional<RunRecord> ReadRecord() const;

  // Makes the folder in which LockFile() is.
  bool MakeParent(std::string* error) const;

  // An empty partial folder but for config.yaml with the settings of the run; what was left behind
  // goes away.
  bool Begin(const StudyRun& run, std::string* error) const;

  // Writes run.json and log.txt, leaves out what is not kept, and publishes. `reference` is written
  // as reference.tum unless it is empty. On failure the partial folder stays.
  bool Commit(const RunRecord& record,
              const StudyRun& run,
              const std::string& reference_path,
              const RecordedTrajectory& reference,
              const std::string& log,
              KeptFiles kept,
              std::string* error) const;

  // Throws the partial folder away, to give room back.
  void Discard() const;

 private:
  bool WriteRunJson(const RunRecord& record,
                    const StudyRun& run,
                    const std::string& reference_path,
                    std::string* error) const;

  std::filesystem::path path_;
  std::filesystem::path partial_;
  std::filesystem::path lock_;
};

}  // namespace radive
