// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/raflow_json.h"

#include <array>
#include <cmath>

#include "radive/io/trajectories/pose_text.h"
#include "radive/util/json.h"

namespace radive {
namespace {

constexpr std::array<const char*, 6> kFields = {
    "car_loc_x", "car_loc_y", "car_loc_z", "car_vel_r", "rcs", "power"};

bool IsNumbers(const Json& value) {
  if (!value.is_array()) return false;
  for (const Json& entry : value) {
    if (!entry.is_number()) return false;
  }
  return true;
}

bool ReadScan(const Json& file, const char* key, PointTable* table, std::string* error) {
  *table = PointTable();
  const auto scan = file.find(key);
  std::array<const Json*, kFields.size()> columns;
  for (std::size_t i = 0; i < kFields.size(); ++i) {
    const bool has_scan = scan != file.end() && scan->is_object();
    const auto column = has_scan ? scan->find(kFields[i]) : Json::const_iterator();
    if (!has_scan || column == scan->end() || !IsNumbers(*column) ||
        (i > 0 && column->size() != columns[0]->size())) {
      *error =
          std::string(key) + "." + kFields[i] + ": expected a list of numbers, one for each point";
      return false;
    }
    columns[i] = &*column;
    table->AddField(kFields[i], NumericType::kFloat64);
  }
  std::string records;
  for (std::size_t k = 0; k < columns[0]->size(); ++k) {
    for (const Json* column : columns) AppendLittleEndian((*column)[k].get<double>(), &records);
  }
  table->num_points = columns[0]->size();
  table->owned.assign(records.begin(), records.end());
  table->data = table->owned.data();
  return true;
}

// Four rows of four numbers.
bool ReadPose(const Json& file, const char* key, MatrixPose* pose) {
  const auto scan = file.find(key);
  if (scan == file.end() || !scan->is_object()) return false;
  const auto rows = scan->find("pose");
  if (rows == scan->end() || !rows->is_array() || rows->size() != 4) return false;
  Eigen::Matrix4d matrix;
  for (int row = 0; row < 4; ++row) {
    const Json& numbers = (*rows)[static_cast<std::size_t>(row)];
    if (!IsNumbers(numbers) || numbers.size() != 4) return false;
    for (int column = 0; column < 4; ++column) {
      matrix(row, column) = numbers[static_cast<std::size_t>(column)].get<double>();
    }
  }
  return RigidPose(matrix.topRows<3>(), pose);
}

}  // namespace

bool ParseRaFlowPair(std::string_view text, RaFlowPair* pair, std::string* error) {
  const Json file = ParseJson(text);
  if (!file.is_object()) {
    *error = "expected a JSON object with the scans pc1 and pc2";
    return false;
  }
  const auto interval = file.find("interval");
  const double seconds =
      interval != file.end() && interval->is_number() ? interval->get<double>() : 0.0;
  if (!(seconds > 0.0 && seconds < 1e3)) {
    *error = "interval: expected the seconds between the two scans";
    return false;
  }
  pair->interval_ns = std::llround(seconds * 1e9);
  return ReadScan(file, "pc1", &pair->first, error) && ReadScan(file, "pc2", &pair->second, error);
}

bool ParseRaFlowPoses(std::string_view text,
                      MatrixPose* T_world_first,
                      MatrixPose* T_world_second,
                      std::string* error) {
  const Json file = ParseJson(text);
  if (file.is_object() && ReadPose(file, "pc1", T_world_first) &&
      ReadPose(file, "pc2", T_world_second)) {
    return true;
  }
  *error = "pc1.pose and pc2.pose: expected four rows of four numbers, a rigid transform each";
  return false;
}

}  // namespace radive
