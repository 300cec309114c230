// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <system_error>

#include "radive/io/bytes/record_file.h"
#include "radive/io/datasets/dataset.h"
#include "radive/io/datasets/dicp_calibration.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr char kDicpTruth[] = "ref_poses.txt";
constexpr char kCalibrationFile[] = "calibration.json";

bool IsDicpTruth(const fs::path& file) { return file.filename() == kDicpTruth; }

// Poses of the vehicle, turned into those of its sensor where calibration.json lies beside them.
bool ReadDicpTruth(const fs::path& path, int /*clip*/, Reference* reference, std::string* error) {
  std::error_code ignored;
  const fs::path file = fs::is_directory(path, ignored) ? path / kDicpTruth : path;
  if (!ReadReferenceText(file, TrajectoryFormat::kTum, reference, error)) return false;
  const fs::path calibration = file.parent_path() / kCalibrationFile;
  if (!fs::exists(calibration, ignored)) return true;
  std::string text;
  MatrixPose T_vehicle_sensor;
  if (!ReadWholeFile(calibration, &text, error)) return false;
  if (!ParseDicpCalibration(text, &T_vehicle_sensor)) {
    *error =
        calibration.string() + ": expected T_V_to_S with translation x y z and quaternion w x y z";
    return false;
  }
  for (RecordedPose& pose : reference->poses)
    pose.T_world_body = pose.T_world_body * T_vehicle_sensor;
  return true;
}

}  // namespace

Dataset DopplerIcpDataset() {
  Dataset dataset;
  dataset.name = "Doppler-ICP";
  DatasetSensor& aeva = dataset.sensors.emplace_back();
  aeva.name = "Doppler-ICP";
  aeva.folders = {"point_clouds"};
  aeva.siblings = {kDicpTruth, kCalibrationFile};
  aeva.layouts = {"dicp4"};
  dataset.truth_files = {{kDicpTruth, ReferenceOptions::Format::kDicp}};
  dataset.truth.format = ReferenceOptions::Format::kDicp;
  dataset.truth.is_file = IsDicpTruth;
  dataset.truth.read = ReadDicpTruth;
  return dataset;
}

}  // namespace radive
