// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/vod_poses.h"

#include <cstddef>
#include <system_error>
#include <vector>

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/scans/scan_folder.h"
#include "radive/io/trajectories/pose_text.h"
#include "radive/util/json.h"

namespace radive {
namespace {

namespace fs = std::filesystem;
constexpr std::string_view kPoseKey = "odomToCamera";
constexpr std::string_view kCalibrationKey = "Tr_velo_to_cam:";

// From the first three rows of four numbers.
bool SetPose(const std::vector<double>& rows, MatrixPose* pose) {
  return RigidPose(Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(rows.data()),
                   pose);
}

bool ReadPose(const fs::path& file, MatrixPose* pose, std::string* error) {
  std::string text, reason;
  if (!ReadWholeFile(file, &text, error)) return false;
  if (ParseVodPose(text, pose, &reason)) return true;
  *error = file.string() + ": " + reason;
  return false;
}

bool ReadCalibration(const fs::path& file, MatrixPose* pose, std::string* error) {
  std::string text, reason;
  if (!ReadWholeFile(file, &text, error)) return false;
  if (ParseVodCalibration(text, pose, &reason)) return true;
  *error = file.string() + ": " + reason;
  return false;
}

}  // namespace

bool ParseVodPose(std::string_view text, MatrixPose* T_odom_camera, std::string* error) {
  *error = "expected a JSON object with " + std::string(kPoseKey) +
           ": 16 numbers, the rows of a rigid 4x4 matrix";
  TextLines lines(text);
  for (std::string_view line; lines.Next(&line);) {
    const Json object = ParseJson(line);
    if (!object.is_object()) continue;
    const auto matrix = object.find(kPoseKey);
    if (matrix == object.end() || !matrix->is_array() || matrix->size() != 16) continue;
    std::vector<double> rows;
    for (const Json& entry : *matrix) {
      if (entry.is_number()) rows.push_back(entry.get<double>());
    }
    return rows.size() == 16 && SetPose(rows, T_odom_camera);
  }
  return false;
}

bool ParseVodCalibration(std::string_view text, MatrixPose* T_camera_sensor, std::string* error) {
  *error = "expected a line '" + std::string(kCalibrationKey) +
           "' with the 12 numbers of a rigid 3x4 matrix";
  TextLines lines(text);
  for (std::string_view line; lines.Next(&line);) {
    if (line.substr(0, kCalibrationKey.size()) != kCalibrationKey) continue;
    std::vector<double> rows;
    for (const std::string_view word : SplitColumns(line.substr(kCalibrationKey.size()))) {
      if (const std::optional<double> number = ParseFinite(word)) rows.push_back(*number);
    }
    return rows.size() == 12 && SetPose(rows, T_camera_sensor);
  }
  return false;
}

std::optional<fs::path> FindVodPoses(const fs::path& path) {
  for (const char* below : {"", "pose", "training/pose", "radar/training/pose"}) {
    const fs::path folder = *below == '\0' ? path : path / below;
    std::vector<std::string> names;
    std::string ignored;
    if (!ListFiles(folder, ".json", &names, &ignored) || names.empty()) continue;
    MatrixPose pose;
    if (ReadPose(folder / names.front(), &pose, &ignored)) return folder;
  }
  return std::nullopt;
}

std::optional<RecordedTrajectory> ReadVodPoses(const fs::path& pose_folder, std::string* error) {
  std::vector<std::string> names;
  if (!ListFiles(pose_folder, ".json", &names, error)) return std::nullopt;
  if (names.empty()) {
    *error = pose_folder.string() + ": expected pose files NNNNN.json, found none";
    return std::nullopt;
  }
  const fs::path folder = fs::absolute(pose_folder).lexically_normal();
  const fs::path parent =
      folder.has_filename() ? folder.parent_path() : folder.parent_path().parent_path();
  RecordedTrajectory poses;
  for (const std::string& name : names) {
    MatrixPose T_odom_camera, T_camera_radar;
    const fs::path calibration =
        parent / "calib" / fs::path(name).replace_extension(".txt").filename();
    if (!ReadPose(pose_folder / name, &T_odom_camera, error) ||
        !ReadCalibration(calibration, &T_camera_radar, error)) {
      return std::nullopt;
    }
    poses.push_back({0, 0.0, T_odom_camera * T_camera_radar});
  }
  return poses;
}

}  // namespace radive
