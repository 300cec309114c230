// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "radive/studies/run_folder.h"
#include "radive/studies/study.h"

namespace radive {

// How a study is to be run.
struct StudyRequest {
  std::filesystem::path output;
  std::filesystem::path program;  // radive_odometry
  int jobs = 1;                   // runs at a time, each a process
  int shard = 0;                  // this part ...
  int num_shards = 1;             // ... of as many
  bool retry = true;              // runs that failed are run again
  KeptFiles kept = KeptFiles::kAll;
  bool quiet = false;                       // no progress and remarks on stderr
  const std::atomic<bool>* stop = nullptr;  // becomes true: stop the runs at hand and return
};

enum class StudyStatus {
  kDone,         // every run is ok or absent
  kSomeFailed,   // some are not, or could not be recorded
  kInterrupted,  // by `stop`
  kFailed        // nothing was run: see the error
};

// Runs what is not complete yet and writes the tables, docs/studies.md says where. Several
// processes may do so in one folder at a time. Call it while this process has one thread.
StudyStatus RunStudy(const Study& study, const StudyRequest& request, std::string* error);

// Runs nothing and writes the tables from the runs there are; kSomeFailed as well when some are
// missing.
StudyStatus CollectStudy(const Study& study, const StudyRequest& request, std::string* error);

}  // namespace radive
