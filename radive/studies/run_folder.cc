// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/run_folder.h"

#include <system_error>
#include <vector>

#include "radive/config/describe_config.h"
#include "radive/config/yaml_settings.h"
#include "radive/io/bytes/whole_file.h"
#include "radive/io/trajectories/trajectory_io.h"
#include "radive/util/durable_files.h"
#include "radive/util/json.h"
#include "radive/util/output_folder.h"
#include "radive/util/text.h"

namespace radive {
namespace {

namespace fs = std::filesystem;
Json ReadJson(const fs::path& file) {
  std::string text;
  std::string ignored;
  if (!ReadTextFile(file.string(), "file", kLargestTable, &text, &ignored)) return Json();
  return ParseJson(text);
}

// True for a file that the folder of a run keeps, when it went well.
bool IsKept(const std::string& name, KeptFiles kept) {
  if (kept == KeptFiles::kAll) return true;
  if (name == "run.json" || name == "config.yaml" || name == "log.txt") return true;
  return kept == KeptFiles::kTrajectories &&
         (name == "trajectory_tum.txt" || name == "trajectory_kitti.txt" ||
          name == "reference.tum");
}

// A file that was begun and not finished, see OutputFile.
bool IsPartial(const std::string& name) {
  return name.front() == '.' && fs::path(name).extension() == ".partial";
}

template <typename Predicate>
void RemoveFiles(const fs::path& folder, const Predicate& is_removed) {
  std::vector<fs::path> removed;
  std::error_code code;
  fs::directory_iterator entry(folder, code);
  for (; !code && entry != fs::directory_iterator(); entry.increment(code)) {
    if (is_removed(entry->path().filename().string())) removed.push_back(entry->path());
  }
  for (const fs::path& path : removed) fs::remove_all(path, code);
}

}  // namespace

RunFolder::RunFolder(const fs::path& output, const StudyRun& run)
    : path_(output / "runs" / run.Name()) {
  const std::string seed = path_.filename().string();
  partial_ = path_.parent_path() / ("." + seed + ".partial");
  lock_ = path_.parent_path() / ("." + seed + ".lock");
}

std::optional<RunRecord> RunFolder::ReadRecord() const {
  const Json json = ReadJson(path_ / "run.json");
  if (!json.is_object() || !json.contains("batch")) return std::nullopt;
  return RunRecordFromJson(json["batch"]);
}

bool RunFolder::MakeParent(std::string* error) const {
  std::error_code code;
  fs::create_directories(path_.parent_path(), code);
  if (code) *error = path_.parent_path().string() + ": cannot be made: " + code.message();
  return !code;
}

bool RunFolder::Begin(const StudyRun& run, std::string* error) const {
  std::error_code code;
  fs::remove_all(OutputFolder::StagedBeside(partial_), code);
  if (!code) fs::remove_all(partial_, code);
  if (!code) fs::create_directory(partial_, code);
  if (code) {
    *error = partial_.string() + ": cannot be made: " + code.message();
    return false;
  }
  // radive_odometry is told to read it, and writes the same text over it.
  return WriteFile(partial_ / "config.yaml", EffectiveConfig(run.config), error);
}

bool RunFolder::WriteRunJson(const RunRecord& record,
                             const StudyRun& run,
                             const std::string& reference_path,
                             std::string* error) const {
  Json json = ReadJson(partial_ / "run.json");
  if (!json.is_object()) json = Json::object();
  if (json.contains("command_line") && json["command_line"].is_string()) {
    // As it can be given again.
    json["command_line"] =
        ReplaceAll(json["command_line"].get<std::string>(), partial_.string(), path_.string());
  }
  Json batch = RunRecordToJson(record);
  batch["reference"] = reference_path;
  batch["start"] = run.start;
  batch["frames"] = run.frames;
  json["batch"] = std::move(batch);
  return WriteFile(partial_ / "run.json", JsonText(json), error);
}

bool RunFolder::Commit(const RunRecord& record,
                       const StudyRun& run,
                       const std::string& reference_path,
                       const RecordedTrajectory& reference,
                       const std::string& log,
                       KeptFiles kept,
                       std::string* error) const {
  // What a broken run left of its files has no use, and may be what filled the disk.
  RemoveFiles(partial_, [&](const std::string& name) {
    return record.status == "ok" ? !IsKept(name, kept) : IsPartial(name);
  });
  const bool has_reference = !reference.empty() && kept != KeptFiles::kScores;
  if (has_reference &&
      !WriteTumTrajectory(partial_ / "reference.tum", ToTrajectory(reference), error)) {
    return false;
  }
  return WriteFile(partial_ / "log.txt", log, error) &&
         WriteRunJson(record, run, reference_path, error) && ReplaceFolder(partial_, path_, error);
}

void RunFolder::Discard() const {
  std::error_code ignored;
  fs::remove_all(OutputFolder::StagedBeside(partial_), ignored);
  fs::remove_all(partial_, ignored);
}

}  // namespace radive
