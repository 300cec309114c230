// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/result_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <system_error>
#include <unordered_set>

#include "radive/io/bytes/whole_file.h"
#include "radive/pipeline/result_rows.h"
#include "radive/util/system_message.h"

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

std::string PartialName(const std::string& name) { return "." + name + ".partial"; }

bool IsResultFile(const std::string& name) {
  return std::any_of(kResultFiles.begin(), kResultFiles.end(), [&name](const char* result) {
    return name == result || name == PartialName(result);
  });
}

}  // namespace

bool ResultWriter::Open(const std::filesystem::path& folder, std::string* error) {
  folder_ = folder;
  // A folder that only has the name of a result is not ours to remove with what it holds.
  const auto is_own = [folder](const std::string& name) {
    std::error_code ignored;
    return IsResultFile(name) && !std::filesystem::is_directory(folder / name, ignored);
  };
  if (!output_.Open(folder, is_own, error)) return false;
  for (const auto& [name, file] : Streams()) {
    names_.push_back(name);
    if (!file->Open(Partial(name), error)) return false;
  }
  scans_.Write(ScansHeader());
  timing_.Write(TimingHeader());
  return true;
}

std::array<std::pair<const char*, OutputFile*>, 4> ResultWriter::Streams() {
  return {{{"trajectory_tum.txt", &tum_},
           {"trajectory_kitti.txt", &kitti_},
           {"scans.csv", &scans_},
           {"timing.csv", &timing_}}};
}

std::filesystem::path ResultWriter::Partial(const std::string& name) const {
  return folder_ / PartialName(name);
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
  names_.push_back(name);
  return WriteFile(Partial(name), text, error);
}

bool ResultWriter::EndScans(std::string* error) {
  return tum_.Close(error) && kitti_.Close(error) && scans_.Close(error) && timing_.Close(error);
}

bool ResultWriter::Publish(std::string* error) {
  if (!EndScans(error) || !output_.Stage(error)) return false;
  for (const std::string& name : names_) {
    // A second name, so that the partial files stay where they are when this is broken off.
    std::error_code code;
    std::filesystem::create_hard_link(Partial(name), output_.staged() / name, code);
    if (code) std::filesystem::copy_file(Partial(name), output_.staged() / name, code);
    if (code) {
      *error = (folder_ / name).string() + ": cannot be written: " + SystemMessage(code);
      return false;
    }
  }
  return output_.Publish(error);
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
