// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/dicp_calibration.h"

#include <cmath>
#include <optional>

#include "radive/util/json.h"

namespace radive {
namespace {

std::optional<double> NumberAt(const Json& object, const char* group, const char* key) {
  const auto found = object.find(group);
  if (found == object.end() || !found->is_object()) return std::nullopt;
  const auto number = found->find(key);
  if (number == found->end() || !number->is_number()) return std::nullopt;
  return number->get<double>();
}

}  // namespace

bool ParseDicpCalibration(std::string_view text, MatrixPose* T_vehicle_sensor) {
  const Json file = ParseJson(text);
  const auto transform = file.is_object() ? file.find("T_V_to_S") : file.end();
  if (!file.is_object() || transform == file.end() || !transform->is_object()) return false;
  const auto x = NumberAt(*transform, "translation", "x");
  const auto y = NumberAt(*transform, "translation", "y");
  const auto z = NumberAt(*transform, "translation", "z");
  const auto qw = NumberAt(*transform, "quaternion", "w");
  const auto qx = NumberAt(*transform, "quaternion", "x");
  const auto qy = NumberAt(*transform, "quaternion", "y");
  const auto qz = NumberAt(*transform, "quaternion", "z");
  if (!x || !y || !z || !qw || !qx || !qy || !qz) return false;
  const Eigen::Quaterniond q(*qw, *qx, *qy, *qz);
  const Eigen::Vector3d translation(*x, *y, *z);
  if (!(std::abs(q.norm() - 1.0) < 1e-3) || !translation.allFinite()) return false;
  *T_vehicle_sensor = MatrixPose(Rigid3(q, translation));
  return true;
}

}  // namespace radive
