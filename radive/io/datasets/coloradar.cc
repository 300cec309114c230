// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <system_error>

#include "radive/io/bytes/stamp_text.h"
#include "radive/io/datasets/dataset.h"
#include "radive/io/scans/scan_stamps.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr char kColoRadarTruth[] = "groundtruth_poses.txt";

// x y z qx qy qz qw, without stamps.
std::optional<PoseColumns> ColoRadarTruthColumns(std::string_view /*names*/) {
  PoseColumns columns;
  columns.position = {0, 1, 2};
  columns.quaternion = {3, 4, 5, 6};
  return columns;
}

bool IsColoRadarTruth(const fs::path& file) { return file.filename() == kColoRadarTruth; }

// groundtruth_poses.txt, and timestamps.txt beside it.
bool ReadColoRadarTruth(const fs::path& path,
                        int /*clip*/,
                        Reference* reference,
                        std::string* error) {
  std::error_code ignored;
  const fs::path file = fs::is_directory(path, ignored) ? path / kColoRadarTruth : path;
  const fs::path stamp_file = file.parent_path() / "timestamps.txt";
  if (!ReadReferenceTable(file, ColoRadarTruthColumns(""), reference, error)) return false;
  const std::optional<StampSequence> sequence = ReadStampFile(stamp_file, kAssumedRate, error);
  if (!sequence) return false;
  reference->has_stamps = true;
  const std::vector<std::int64_t>& stamps_ns = sequence->stamps_ns;
  if (stamps_ns.size() != reference->poses.size()) {
    *error = stamp_file.string() + ": has " + std::to_string(stamps_ns.size()) +
             " stamps, expected one for each of the " + std::to_string(reference->poses.size()) +
             " poses of " + file.string();
    return false;
  }
  for (std::size_t i = 0; i < stamps_ns.size(); ++i) {
    reference->poses[i].stamp_ns = stamps_ns[i];
    reference->poses[i].stamp_s = StampSeconds(stamps_ns[i]);
  }
  return true;
}

}  // namespace

Dataset ColoRadarDataset() {
  Dataset dataset;
  dataset.name = "ColoRadar";
  DatasetSensor& radar = dataset.sensors.emplace_back();
  radar.name = "ColoRadar";
  radar.folders = {"single_chip/pointclouds/data"};
  radar.layouts = {"coloradar5"};
  radar.written.word = "coloradar";
  radar.written.folder = "single_chip/pointclouds/data";
  radar.written.columns = "coloradar5";
  radar.written.naming = WrittenForm::Naming::kRadarPointcloud;
  dataset.truth_files = {
      {"groundtruth/groundtruth_poses.txt", ReferenceOptions::Format::kColoRadar},
      {kColoRadarTruth, ReferenceOptions::Format::kColoRadar}};
  dataset.truth.format = ReferenceOptions::Format::kColoRadar;
  dataset.truth.is_file = IsColoRadarTruth;
  dataset.truth.columns = ColoRadarTruthColumns;
  dataset.truth.read = ReadColoRadarTruth;
  return dataset;
}

}  // namespace radive
