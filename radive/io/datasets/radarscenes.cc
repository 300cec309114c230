// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <system_error>

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/datasets/dataset.h"
#include "radive/io/datasets/radarscenes_hdf5.h"
#include "radive/io/datasets/radarscenes_source.h"
#include "radive/io/scans/scan_folder.h"
#include "radive/io/trajectories/pose_text.h"
#include "radive/util/text.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr char kTables[] = "_scans.csv";
// Of the four, 2 and 3 look ahead.
constexpr char kUsualRadar[] = "2";

std::vector<std::string> RadarScenesTablesIn(const fs::path& folder) {
  std::vector<std::string> names;
  std::string ignored;
  ListFiles(folder, kTables, &names, &ignored);
  return names;
}

bool RecogniseRadarScenes(const fs::path& path, const std::string& folder, std::string* what) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) {
    *what = "an HDF5 file, as RadarScenes has";
    return FindRadarScenesHdf5(path).has_value();
  }
  for (const std::string& name : RadarScenesTablesIn(path / folder)) {
    *what = "holds " + name;
    if (StartsWith(name, "radar")) return true;
  }
  *what = "holds radar_data.h5";
  return FindRadarScenesHdf5(path, folder).has_value();
}

std::unique_ptr<ScanSource> OpenRadarScenes(const fs::path& path,
                                            const InputOptions& options,
                                            std::string* error) {
  InputOptions chosen = options;
  if (chosen.radar.empty()) chosen.radar = kUsualRadar;
  if (const auto file = FindRadarScenesHdf5(path, chosen.folder)) {
    return RadarScenesHdf5Source::Open(*file, chosen, error);
  }
  return RadarScenesSource::Open(path, chosen, error);
}

std::optional<std::vector<RadarInput>> ListRadarScenesRadars(const fs::path& path,
                                                             const InputOptions& options,
                                                             std::string* error) {
  const std::optional<fs::path> file = FindRadarScenesHdf5(path, options.folder);
  const std::optional<std::vector<int>> numbers =
      file ? RadarsOfRadarScenesHdf5(*file, error) : RadarsOfRadarScenes(path / options.folder);
  if (!numbers) return std::nullopt;
  std::vector<RadarInput> radars;
  for (const int number : *numbers) {
    radars.push_back({number, options});
    radars.back().options.radar = std::to_string(number);
  }
  return radars;
}

// timestamp_odom, x, y and yaw: the pose of the car, whose origin is at the rear axle.
std::optional<PoseColumns> RadarScenesTruthColumns(std::string_view names) {
  const std::vector<std::string_view> words = SplitColumns(names);
  // Units may follow in brackets, and a '#' stand in front.
  const auto find = [&](std::string_view name) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string column = LowerCase(words[i]);
      const std::string_view word = std::string_view(column).substr(column[0] == '#' ? 1 : 0);
      if (word.substr(0, word.find_first_of("[(")) == name) return static_cast<int>(i);
    }
    return -1;
  };
  PoseColumns columns;
  columns.has_names = true;
  columns.stamp = find("timestamp_odom");
  columns.position = {find("x"), find("y"), -1};
  columns.angles = {-1, -1, find("yaw")};
  if (std::min({columns.stamp, columns.position[0], columns.position[1], columns.angles[2]}) < 0) {
    return std::nullopt;
  }
  return columns;
}

bool ReadRadarScenesTable(const fs::path& file, RecordedTrajectory* poses, std::string* error) {
  std::string text;
  if (!ReadWholeFile(file, &text, error)) return false;
  TextLines lines(text);
  std::string_view names;
  lines.Next(&names);
  const std::optional<PoseColumns> columns = RadarScenesTruthColumns(names);
  if (columns) return ParsePoseTable(text, *columns, file.string(), poses, error);
  *error = file.string() +
           ":1: expected the names of the columns, among them timestamp_odom, x, y and yaw, "
           "found " +
           Quoted(names);
  return false;
}

std::optional<fs::path> FindRadarScenesTruth(const fs::path& folder) {
  if (RadarScenesTablesIn(folder).empty() && !FindRadarScenesHdf5(folder)) return std::nullopt;
  return folder;
}

bool IsRadarScenesTruth(const fs::path& file) {
  return EndsWith(file.filename().string(), kTables) || file.extension() == ".h5";
}

// The tables of all radars: each has the pose of the car at the odometry's stamp next to each scan.
bool ReadRadarScenesTruth(const fs::path& path,
                          int /*clip*/,
                          Reference* reference,
                          std::string* error) {
  std::error_code ignored;
  if (const std::optional<fs::path> hdf5 = FindRadarScenesHdf5(path)) {
    return SetPoses(ReadRadarScenesOdometry(*hdf5, error), /*has_stamps=*/true, reference);
  }
  std::vector<fs::path> files = {path};
  if (fs::is_directory(path, ignored)) {
    files.clear();
    for (const std::string& name : RadarScenesTablesIn(path)) files.push_back(path / name);
  }
  RecordedTrajectory& all = reference->poses;
  for (const fs::path& file : files) {
    RecordedTrajectory poses;
    if (!ReadRadarScenesTable(file, &poses, error)) return false;
    all.insert(all.end(), poses.begin(), poses.end());
  }
  std::stable_sort(all.begin(), all.end(), [](const RecordedPose& a, const RecordedPose& b) {
    return a.stamp_ns < b.stamp_ns;
  });
  const auto is_again = [](const RecordedPose& a, const RecordedPose& b) {
    return a.stamp_ns == b.stamp_ns;
  };
  all.erase(std::unique(all.begin(), all.end(), is_again), all.end());
  if (all.empty()) *error = path.string() + ": expected radarK_scans.csv, found none";
  return !all.empty();
}

}  // namespace

Dataset RadarScenesDataset() {
  Dataset dataset;
  dataset.name = "RadarScenes";
  dataset.recognise = RecogniseRadarScenes;
  DatasetSensor& radar = dataset.sensors.emplace_back();
  radar.name = "RadarScenes";
  radar.format = InputOptions::Format::kRadarScenes;
  radar.open = OpenRadarScenes;
  dataset.list_radars = ListRadarScenesRadars;
  dataset.radar_files = "radar1_scans.csv, radar2_scans.csv, ...";
  dataset.truth.format = ReferenceOptions::Format::kRadarScenes;
  dataset.truth.files = "radarK_scans.csv";
  dataset.truth.find = FindRadarScenesTruth;
  dataset.truth.is_file = IsRadarScenesTruth;
  dataset.truth.columns = RadarScenesTruthColumns;
  dataset.truth.read = ReadRadarScenesTruth;
  return dataset;
}

}  // namespace radive
