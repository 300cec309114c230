// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/result_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "radive/pipeline/result_rows.h"

namespace radive {
namespace {

constexpr std::array<const char*, 11> kResultFiles = {"trajectory_tum.txt",
                                                      "trajectory_kitti.txt",
                                                      "scans.csv",
                                                      "timing.csv",
                                                      "map.ply",
                                                      "neural_points.ply",
                                                      "mesh.ply",
                                                      "sdf_slice.ply",
                                                      "scores.json",
                                                      "config.yaml",
                                                      "run.json"};

bool IsResultFile(const std::string& name) {
  return std::any_of(kResultFiles.begin(), kResultFiles.end(), [&name](const char* result) {
    return name == result || name == OutputFile::PartialName(result);
  });
}

// Creates `folder` unless it is there already; error when it holds files that are not ours.
bool PrepareFolder(const std::filesystem::path& folder, std::string* error) {
  std::error_code code;
  if (std::filesystem::exists(folder, code) && !std::filesystem::is_directory(folder, code)) {
    *error = folder.string() + ": the output must be a folder, is a file";
    return false;
  }
  std::filesystem::create_directories(folder, code);
  if (code) {
    *error = folder.string() + ": cannot create the output folder: " + code.message();
    return false;
  }
  std::string stranger;  // the first by name, so that the message is always the same
  std::filesystem::directory_iterator entry(folder, code);
  for (; !code && entry != std::filesystem::directory_iterator(); entry.increment(code)) {
    const std::string name = entry->path().filename().string();
    if (!IsResultFile(name) && (stranger.empty() || name < stranger)) stranger = name;
  }
  if (code) {
    *error = folder.string() + ": cannot list the output folder: " + code.message();
    return false;
  }
  if (!stranger.empty()) {
    *error = folder.string() +
             ": the output folder must be new, empty or hold earlier results only; it holds " +
             stranger;
    return false;
  }
  return true;
}

}  // namespace

bool ResultWriter::Open(const std::filesystem::path& folder, std::string* error) {
  folder_ = folder;
  if (!PrepareFolder(folder, error) || !tum_.Open(folder, "trajectory_tum.txt", error) ||
      !kitti_.Open(folder, "trajectory_kitti.txt", error) ||
      !scans_.Open(folder, "scans.csv", error) || !timing_.Open(folder, "timing.csv", error)) {
    return false;
  }
  scans_.Write(ScansHeader());
  timing_.Write(TimingHeader());
  return true;
}

bool ResultWriter::AddScan(const ScanInfo& info, const OdometryResult& result, std::string* error) {
  tum_.Write(TumRow(result));
  kitti_.Write(KittiRow(result));
  scans_.Write(ScansRow(result, info.radar));
  timing_.Write(TimingRow(result, info.read_ms));
  // Flushed so that a killed run leaves its partial files up to the last scan.
  return tum_.Flush(error) && kitti_.Flush(error) && scans_.Flush(error) && timing_.Flush(error);
}

bool ResultWriter::WriteText(const std::string& name, const std::string& text, std::string* error) {
  OutputFile file;
  if (!file.Open(folder_, name, error)) return false;
  file.Write(text);
  return file.Commit(error);
}

void ResultWriter::RemoveEarlier(const std::string& name) {
  std::error_code ignored;
  std::filesystem::remove(folder_ / name, ignored);
}

bool ResultWriter::Finish(std::string* error) {
  std::string first_error;
  for (OutputFile* file : {&tum_, &kitti_, &scans_, &timing_}) {
    std::string file_error;
    if (!file->Commit(&file_error) && first_error.empty()) first_error = file_error;
  }
  if (!first_error.empty()) *error = first_error;
  return first_error.empty();
}

void MapThinner::Add(const std::vector<Eigen::Vector3d>& points) {
  constexpr std::int64_t kBias = 1 << 20;  // 21 bits an axis: a million cubes to each side
  const auto cell = [this](double coordinate) {
    const double index = std::floor(coordinate / resolution_);
    const double limit = static_cast<double>(kBias) - 1.0;
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::clamp(index, -limit, limit)) +
                                      kBias);
  };
  for (const Eigen::Vector3d& p : points) {
    if (!p.allFinite()) continue;
    if (!(resolution_ > 0.0) ||
        taken_.insert(cell(p.x()) << 42 | cell(p.y()) << 21 | cell(p.z())).second) {
      points_.push_back(p);
    }
  }
}

}  // namespace radive
