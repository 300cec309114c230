// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <system_error>

#include "radive/io/datasets/dataset.h"
#include "radive/io/datasets/raflow_source.h"
#include "radive/io/scans/scan_folder.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

bool IsRaFlowFile(const fs::path& file) {
  std::int64_t sequence, sample;
  return ParseRaFlowName(file.filename().string(), &sequence, &sample);
}

// Looks two folders deep.
bool RecogniseRaFlow(const fs::path& path, const std::string& folder, std::string* what) {
  std::error_code failure;
  if (fs::is_regular_file(path, failure)) {
    *what = "is named as RaFlow's files are";
    return IsRaFlowFile(path);
  }
  for (fs::recursive_directory_iterator it(path / folder, failure), end; !failure && it != end;
       it.increment(failure)) {
    if (it.depth() >= 2) it.disable_recursion_pending();
    if (!IsRaFlowFile(it->path())) continue;
    *what = "holds files named as RaFlow's, such as " + it->path().filename().string();
    return true;
  }
  return false;
}

std::unique_ptr<ScanSource> OpenRaFlow(const fs::path& path,
                                       const InputOptions& options,
                                       std::string* error) {
  return RaFlowSource::Open(path, options, error);
}

std::optional<fs::path> FindRaFlowTruth(const fs::path& folder) {
  std::vector<std::string> names;
  std::string ignored;
  ListFiles(folder, ".json", &names, &ignored);
  for (const std::string& name : names) {
    if (IsRaFlowFile(name)) return folder;
  }
  return std::nullopt;
}

bool ReadRaFlowTruth(const fs::path& path, int clip, Reference* reference, std::string* error) {
  return SetPoses(ReadRaFlowPoses(path, clip, error), /*has_stamps=*/true, reference);
}

}  // namespace

Dataset RaFlowDataset() {
  Dataset dataset;
  dataset.name = "RaFlow";
  dataset.recognise = RecogniseRaFlow;
  DatasetSensor& radar = dataset.sensors.emplace_back();
  radar.name = "RaFlow";
  radar.extension = ".json";
  radar.format = InputOptions::Format::kRaFlow;
  radar.open = OpenRaFlow;
  dataset.truth.format = ReferenceOptions::Format::kRaFlow;
  dataset.truth.files = "radar_seqs-*.json";
  dataset.truth.find = FindRaFlowTruth;
  dataset.truth.is_file = IsRaFlowFile;
  dataset.truth.read = ReadRaFlowTruth;
  return dataset;
}

}  // namespace radive
