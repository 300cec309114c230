// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "radive/studies/run_record.h"
#include "radive/studies/study_runs.h"

// The tables of a study, made from the run folders alone: whatever happened on the way, the same
// runs give the same tables. docs/studies.md says what is in them.

namespace radive {

// Makes the output folder with study.json and published.csv.
bool MakeStudyFolder(const Study& study, const std::filesystem::path& output, std::string* error);

struct TableCounts {
  int all = 0;     // runs of the study
  int found = 0;   // that have ended, or never can be run
  int failed = 0;  // of those, that are neither ok nor marked as absent
};

// What a run without input on this machine counts as: "absent" or "failed", as the study says.
RunRecord AbsentRecord(const Study& study, const StudyRun& run);

// Writes results.csv, results.sqlite, timings.csv, summary.csv and summary.md from the folders of
// `runs` whose records have the settings of now. `unsaved` are records of runs without folder.
bool WriteTables(const Study& study,
                 const std::vector<StudyRun>& runs,
                 const std::filesystem::path& output,
                 const std::vector<RunRecord>& unsaved,
                 std::string* error,
                 TableCounts* counts = nullptr);

// The text of results.csv and of timings.csv; `records` in their order.
std::string ResultsCsv(const std::vector<RunRecord>& records);
std::string TimingsCsv(const std::vector<RunRecord>& records);

}  // namespace radive
