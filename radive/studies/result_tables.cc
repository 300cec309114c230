// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/result_tables.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "radive/config/yaml_settings.h"
#include "radive/io/bytes/whole_file.h"
#include "radive/studies/results_database.h"
#include "radive/studies/run_folder.h"
#include "radive/studies/summary.h"
#include "radive/util/file_lock.h"
#include "radive/util/json.h"
#include "radive/util/number_text.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

namespace fs = std::filesystem;
std::string CellText(double value) { return ShortText(value); }
std::string CellText(int value) { return std::to_string(value); }

template <typename Value>
std::string Cell(const std::optional<Value>& value) {
  return value ? CellText(*value) : "";
}

// As RFC 4180 has it, on one line.
std::string Cell(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string Row(const std::vector<std::string>& cells) {
  std::string row;
  for (std::size_t i = 0; i < cells.size(); ++i) row += (i == 0 ? "" : ",") + cells[i];
  return row + "\n";
}

// A study names its tables' owner: one process at a time writes into them.
std::optional<FileLock> LockTables(const fs::path& output, std::string* error) {
  return FileLock::Take(output / ".tables.lock", FileLock::Wait::kYes, error);
}

Json FieldsJson(const std::vector<OptionField>& fields, const std::vector<std::string>& left_out) {
  Json json = Json::object();
  for (const OptionField& field : fields) {
    if (std::find(left_out.begin(), left_out.end(), field.name) == left_out.end()) {
      json[field.name] = field.ToString();
    }
  }
  return json;
}

std::string StudyJson(Study study) {
  Json json;
  json["name"] = study.name;
  json["sequences"] = Json::array();
  for (const StudySequence& sequence : study.sequences) {
    json["sequences"].push_back({{"name", sequence.name},
                                 {"input", sequence.input.string()},
                                 {"reference", sequence.reference.string()},
                                 {"scenario", sequence.scenario},
                                 {"config", sequence.config},
                                 {"set", sequence.set}});
  }
  json["variants"] = Json::array();
  for (const StudyVariant& variant : study.variants) {
    json["variants"].push_back(
        {{"name", variant.name}, {"label", variant.label}, {"set", variant.set}});
  }
  json["seeds"] = study.seeds;
  json["perturb"] = FieldsJson(study.perturb.Fields(), {});
  json["evaluate"] = FieldsJson(study.evaluation.Fields(),
                                {"metric", "relation", "match", "max_time_difference", "max_gap"});
  return JsonText(json);
}

// What is known of each run that has ended.
std::vector<RunRecord> Gather(const Study& study,
                              const std::vector<StudyRun>& runs,
                              const fs::path& output,
                              const std::vector<RunRecord>& unsaved) {
  std::vector<RunRecord> records;
  for (const StudyRun& run : runs) {
    auto record = RunFolder(output, run).ReadRecord();
    if (record && record->config_hash != ConfigHash(study, run)) record.reset();
    std::error_code ignored;
    const bool is_absent =
        !run.sequence->is_simulated() && !fs::exists(run.sequence->input, ignored);
    if (is_absent && (!record || record->status != "ok")) record = AbsentRecord(study, run);
    for (const RunRecord& other : unsaved) {
      const bool is_same = other.sequence == run.sequence->name &&
                           other.variant == run.variant->name && other.seed == run.seed;
      if (is_same) record = other;
    }
    if (record) records.push_back(*std::move(record));
  }
  std::sort(records.begin(), records.end());
  return records;
}

}  // namespace

bool MakeStudyFolder(const Study& study, const fs::path& output, std::string* error) {
  std::error_code code;
  fs::create_directories(output, code);
  if (code) {
    *error = output.string() + ": the output folder cannot be made: " + SystemMessage(code);
    return false;
  }
  const auto lock = LockTables(output, error);
  if (!lock || !WriteWholeFile(output / "study.json", StudyJson(study), error)) return false;
  if (study.published.empty()) return true;
  std::string text;
  return ReadTextFile(study.published.string(), "published figures", kLargestTable, &text, error) &&
         WriteWholeFile(output / "published.csv", text, error);
}

RunRecord AbsentRecord(const Study& study, const StudyRun& run) {
  RunRecord record;
  record.sequence = run.sequence->name;
  record.variant = run.variant->name;
  record.seed = run.seed;
  record.status = study.absent == Study::Absent::kMark ? "absent" : "failed";
  record.message = run.sequence->input.string() + ": no such file or folder";
  return record;
}

std::string ResultsCsv(const std::vector<RunRecord>& records) {
  std::string text =
      "sequence,variant,seed,status,message,ate_t,ate_r,rpe_t,rpe_r,drift_t,drift_r,scans,"
      "registered,path_length,warnings,input_hash,config_hash,program_hash\n";
  for (const RunRecord& record : records) {
    const RunScores& scores = record.scores;
    text += Row({record.sequence,
                 record.variant,
                 std::to_string(record.seed),
                 record.status,
                 Cell(record.message),
                 Cell(scores.ate_t),
                 Cell(scores.ate_r),
                 Cell(scores.rpe_t),
                 Cell(scores.rpe_r),
                 Cell(scores.drift_t),
                 Cell(scores.drift_r),
                 Cell(record.scans),
                 Cell(record.registered),
                 Cell(scores.path_length),
                 Cell(record.warnings),
                 record.input_hash,
                 record.config_hash,
                 record.program_hash});
  }
  return text;
}

std::string TimingsCsv(const std::vector<RunRecord>& records) {
  std::string text =
      "sequence,variant,seed,wall_s,cpu_s,ms_per_scan_median,ms_per_scan_p95,max_rss_mb\n";
  for (const RunRecord& record : records) {
    if (record.status != "ok") continue;
    const RunTiming& timing = record.timing;
    text += Row({record.sequence,
                 record.variant,
                 std::to_string(record.seed),
                 CellText(timing.wall_s),
                 CellText(timing.cpu_s),
                 CellText(timing.ms_per_scan_median),
                 CellText(timing.ms_per_scan_p95),
                 CellText(timing.max_rss_mb)});
  }
  return text;
}

bool WriteTables(const Study& study,
                 const std::vector<StudyRun>& runs,
                 const fs::path& output,
                 const std::vector<RunRecord>& unsaved,
                 std::string* error,
                 TableCounts* counts) {
  // Read and written under one lock: the last process to come here sees all runs.
  const auto lock = LockTables(output, error);
  if (!lock) return false;
  const std::vector<RunRecord> records = Gather(study, runs, output, unsaved);
  if (counts != nullptr) {
    counts->all = static_cast<int>(runs.size());
    counts->found = static_cast<int>(records.size());
    counts->failed =
        static_cast<int>(std::count_if(records.begin(), records.end(), [](const RunRecord& record) {
          return record.status != "ok" && record.status != "absent";
        }));
  }
  const std::vector<SummaryRow> summary = Summarise(study, records);
  return WriteWholeFile(output / "results.csv", ResultsCsv(records), error) &&
         WriteWholeFile(output / "timings.csv", TimingsCsv(records), error) &&
         WriteWholeFile(output / "summary.csv", SummaryCsv(summary), error) &&
         WriteWholeFile(output / "summary.md", SummaryMarkdown(study, summary), error) &&
         WriteResultsDatabase(output / "results.sqlite", records, error);
}

}  // namespace radive
