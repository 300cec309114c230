// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "radive/geometry/matrix_pose.h"
#include "radive/io/bytes/number_text.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// What stands between the columns of text files with poses.
inline constexpr std::string_view kColumnSeparators = " \t,;\r";

// The columns of a line; several separators in a row count as one.
inline std::vector<std::string_view> SplitColumns(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(kColumnSeparators);
       begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kColumnSeparators, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kColumnSeparators, end);
  }
  return words;
}

// The nearest double; nothing for other words, for infinity and for what is no number.
inline std::optional<double> ParseFinite(std::string_view text) {
  const std::optional<double> value = ParseDouble(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

// True for a line with the names of the columns: it has words, and none of them is a number.
inline bool HoldsNamesOnly(std::string_view line) {
  const std::vector<std::string_view> words = SplitColumns(line);
  return !words.empty() && std::none_of(words.begin(), words.end(), [](std::string_view word) {
    return ParseDouble(word).has_value();
  });
}

// Sets the rotation of a quaternion of any length, and that length; identity for (almost) zero
// ones, as evo has it.
inline void SetRotation(double w, double x, double y, double z, RecordedPose* pose) {
  const Eigen::Quaterniond q(w, x, y, z);
  const bool is_zero = q.squaredNorm() < 4.0 * std::numeric_limits<double>::epsilon();
  pose->quaternion_norm = is_zero ? 0.0 : q.norm();
  pose->T_world_body.rotation =
      is_zero ? Eigen::Matrix3d::Identity() : q.normalized().toRotationMatrix();
}

// The pose with the rows [R | t]. Files have six digits or so: R is made a rotation. False when it
// is far from one, or t is not finite.
inline bool RigidPose(const Eigen::Matrix<double, 3, 4>& rows, MatrixPose* pose) {
  const Eigen::Matrix3d R = rows.leftCols<3>();
  const bool is_rotation =
      (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-3 && R.determinant() > 0.0;
  if (!is_rotation || !rows.col(3).allFinite()) return false;
  *pose = MatrixPose(Rigid3(Eigen::Quaterniond(R), rows.col(3)));
  return true;
}

}  // namespace radive
