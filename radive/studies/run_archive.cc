// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/run_archive.h"

#include <system_error>

#include "radive/util/text.h"

namespace radive {

RunRecord RunArchive::NewRecord(const StudyRun& run,
                                const std::string& input_hash,
                                const std::string& config_hash) const {
  RunRecord record;
  record.sequence = run.sequence->name;
  record.variant = run.variant->name;
  record.seed = run.seed;
  record.input_hash = input_hash;
  record.config_hash = config_hash;
  record.program_hash = options_.program_hash;
  return record;
}

bool RunArchive::IsComplete(const StudyRun& run, RunRecord* record) const {
  const auto found = RunFolder(options_.output, run).ReadRecord();
  if (!found || !found->HasHashesOf(*record)) return false;
  if (found->status != "ok" && options_.retry) return false;
  *record = *found;
  return true;
}

bool RunArchive::IsCompleteWithoutInput(const StudyRun& run, RunRecord* record) const {
  const auto found = RunFolder(options_.output, run).ReadRecord();
  if (!found || found->status != "ok") return false;
  record->input_hash = found->input_hash;
  return IsComplete(run, record);
}

void RunArchive::Save(const StudyRun& run,
                      const std::filesystem::path& reference_path,
                      const RecordedTrajectory& reference,
                      const std::string& log,
                      RunRecord* record) {
  const RunFolder folder(options_.output, run);
  // Messages name the folder as it is called in the end, so that they are always the same.
  const auto use_final_path = [&] {
    record->message =
        ReplaceAll(record->message, folder.partial().string(), folder.path().string());
  };
  use_final_path();
  std::string error;
  std::error_code code;
  if (!std::filesystem::exists(folder.partial(), code)) folder.Begin(run, &error);
  if (folder.Commit(*record, run, reference_path.string(), reference, log, options_.kept, &error)) {
    return;
  }
  folder.Discard();
  if (record->status == "ok") {
    record->status = "failed";
    record->message = error;
    record->scores = RunScores();
    use_final_path();
  }
  KeepUnsaved(*record);
}

}  // namespace radive
