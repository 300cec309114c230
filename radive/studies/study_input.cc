// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/study_input.h"

#include <system_error>
#include <vector>

#include "radive/config/yaml_settings.h"
#include "radive/io/bytes/whole_file.h"
#include "radive/pipeline/simulation_writer.h"
#include "radive/util/content_hash.h"
#include "radive/util/json.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

int DriveSeed(const StudyRun& run) {
  if (!run.sequence->is_simulated()) return 0;
  return run.sequence->has_fixed_drive ? run.sequence->simulation.seed : run.seed;
}

}  // namespace

StudyInput::StudyInput(const fs::path& output,
                       const StudyRun& run,
                       const std::string& simulator_hash)
    : output_(output),
      name_(run.sequence->name + "/" + std::to_string(DriveSeed(run))),
      is_simulated_(run.sequence->is_simulated()),
      scenario_(run.sequence->scenario),
      simulation_(run.sequence->simulation),
      simulator_hash_(simulator_hash),
      folder_(run.sequence->input),
      reference_(run.sequence->reference) {
  if (!is_simulated_) return;
  simulation_.seed = DriveSeed(run);
  folder_ = output_ / "data" / name_;
  reference_ = folder_ / "gt_tum.txt";
}

fs::path StudyInput::Note(const std::string& extension) const {
  return output_ / "inputs" / (name_ + extension);
}

bool StudyInput::IsAbsent() const {
  std::error_code ignored;
  return !is_simulated_ && !fs::exists(folder_, ignored);
}

std::optional<std::string> StudyInput::Signature() const {
  ContentHash hash;
  if (is_simulated_) {
    SimulationOptions options = simulation_;
    hash.AddPart(simulator_hash_);
    hash.AddPart(scenario_);
    for (const OptionField& field : options.Fields()) hash.AddPart(field.ToString());
  }
  for (const fs::path& path : {folder_, reference_}) {
    if (path.empty()) continue;
    const auto signature = TreeSignature(path);
    if (!signature) return std::nullopt;
    hash.AddPart(fs::absolute(path).string());
    hash.AddPart(*signature);
  }
  return hash.Hex();
}

std::optional<std::string> StudyInput::KnownHash() const {
  std::string text;
  std::string ignored;
  if (!ReadTextFile(Note(".json").string(), "note", kLargestTable, &text, &ignored))
    return std::nullopt;
  const auto note = ParseJson(text);
  const auto signature = Signature();
  if (!note.is_object() || !signature || note.value("signature", "") != *signature) {
    return std::nullopt;
  }
  return note.value("hash", "");
}

bool StudyInput::Simulate(std::string* error) const {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
  return WriteSimulation(scenario_, simulation_, "raw", folder_, {}, error);
}

bool StudyInput::Prepare(std::string* error) const {
  if (KnownHash()) return true;  // another process was faster
  if (is_simulated_ && !Simulate(error)) return false;
  ContentHash hash;
  for (const fs::path& path : {folder_, reference_}) {
    if (path.empty()) continue;
    const auto part = HashTree(path, error);
    if (!part) return false;
    hash.AddPart(*part);
  }
  const auto signature = Signature();
  if (!signature) {
    *error = folder_.string() + ": changed while it was read";
    return false;
  }
  const Json note = {{"signature", *signature}, {"hash", hash.Hex()}};
  return WriteWholeFile(Note(".json"), JsonText(note), error);
}

bool StudyInput::MakeFolders(std::string* error) const {
  std::vector<fs::path> folders = {Note("").parent_path()};
  if (is_simulated_) folders.push_back(folder_.parent_path());
  for (const fs::path& folder : folders) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (code) {
      *error = folder.string() + ": cannot be made: " + code.message();
      return false;
    }
  }
  return true;
}

}  // namespace radive
