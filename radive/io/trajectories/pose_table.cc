// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/pose_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

#include "radive/geometry/roll_pitch_yaw.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/trajectories/check_poses.h"
#include "radive/io/trajectories/pose_text.h"

namespace radive {
namespace {

using Words = std::vector<std::string>;

// Ten turns, as of an angle that counts on in a spiral: of degrees it is soon exceeded [rad].
constexpr double kLargestAngle = 63.0;

bool IsThere(int column) { return column >= 0; }

// The columns that every line must have.
std::vector<int> NeededColumns(const PoseColumns& columns) {
  std::vector<int> needed;
  const auto add = [&needed](const auto& group) {
    std::copy_if(group.begin(), group.end(), std::back_inserter(needed), &IsThere);
  };
  add(std::array<int, 2>{columns.stamp, columns.nanoseconds});
  add(columns.matrix);
  add(columns.position);
  add(columns.quaternion);
  add(columns.angles);
  return needed;
}

Eigen::Matrix3d RotationOfAngles(const std::array<double, 3>& angles, bool are_passive) {
  const Eigen::Matrix3d rotation =
      RotationFromRollPitchYaw(angles[0], angles[1], angles[2]).toRotationMatrix();
  return are_passive ? Eigen::Matrix3d(rotation.transpose()) : rotation;
}

bool SetStamp(const Words& words, const PoseColumns& columns, RecordedPose* pose) {
  const std::string& text = words[static_cast<std::size_t>(columns.stamp)];
  const bool counts_nanoseconds = !columns.has_stamp_unit && columns.stamp_exponent == 0 &&
                                  !IsThere(columns.nanoseconds) && LooksLikeNanoseconds(text);
  const int unit = counts_nanoseconds ? -9 : columns.stamp_exponent;
  const std::optional<std::int64_t> stamp_ns = ParseStamp(text, unit);
  const std::optional<double> value = ParseFinite(text);
  if (!stamp_ns || !value) return false;
  pose->stamp_ns = *stamp_ns;
  pose->stamp_s = unit == 0 ? *value : *value / std::pow(10.0, -unit);
  if (!IsThere(columns.nanoseconds)) return true;
  const auto rest = ParseStamp(words[static_cast<std::size_t>(columns.nanoseconds)], -9);
  if (!rest || *rest < 0 || *rest >= 1'000'000'000) return false;
  if (pose->stamp_ns > std::numeric_limits<std::int64_t>::max() - *rest) return false;
  pose->stamp_ns += *rest;
  pose->stamp_s = StampSeconds(pose->stamp_ns);
  return true;
}

// One line to a pose; its columns are there. False when one is no finite number, which `bad` is.
// `too_large`: an angle that can hardly be radians.
bool SetPose(
    const Words& words, const PoseColumns& columns, RecordedPose* pose, int* bad, int* too_large) {
  const auto value = [&](int column) {
    if (column < 0) return 0.0;
    const std::optional<double> number = ParseFinite(words[static_cast<std::size_t>(column)]);
    if (!number) *bad = column;
    return number.value_or(0.0);
  };
  *bad = *too_large = -1;
  const std::array<int, 3>& p = columns.position;
  pose->T_world_body.translation << value(p[0]), value(p[1]), value(p[2]);
  const std::array<int, 4>& q = columns.quaternion;
  if (IsThere(columns.matrix[0])) {
    Eigen::Matrix<double, 3, 4> rows;
    for (int i = 0; i < 12; ++i) {
      rows(i / 4, i % 4) = value(columns.matrix[static_cast<std::size_t>(i)]);
    }
    pose->T_world_body.rotation = rows.leftCols<3>();
    pose->T_world_body.translation = rows.col(3);
  } else if (IsThere(q[0])) {
    SetRotation(value(q[3]), value(q[0]), value(q[1]), value(q[2]), pose);
  } else {
    const std::array<int, 3>& a = columns.angles;
    for (const int column : a) {
      if (columns.angle_unit == 1.0 && std::abs(value(column)) > kLargestAngle) *too_large = column;
    }
    pose->T_world_body.rotation = RotationOfAngles({columns.angle_unit * value(a[0]),
                                                    columns.angle_unit * value(a[1]),
                                                    columns.angle_unit * value(a[2])},
                                                   columns.angles_are_passive);
  }
  if (*bad < 0 && IsThere(columns.stamp) && !SetStamp(words, columns, pose)) *bad = columns.stamp;
  return *bad < 0;
}

bool IsContent(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kColumnSeparators);
  return first != std::string_view::npos && line[first] != '#' && line[first] != '%';
}

}  // namespace

std::vector<std::string> SplitPoseLine(std::string_view line, char delimiter) {
  std::vector<std::string> words;
  if (delimiter == '\0') {
    for (const std::string_view word : SplitColumns(line)) words.emplace_back(word);
    return words;
  }
  if (delimiter == ' ') {
    for (std::string_view word = TakeWord(&line); !word.empty(); word = TakeWord(&line)) {
      words.emplace_back(word);
    }
  }
  while (delimiter != ' ') {
    const std::size_t end = line.find(delimiter);
    words.emplace_back(TrimBlanks(line.substr(0, end)));
    if (end == std::string_view::npos) break;
    line.remove_prefix(end + 1);
  }
  for (std::string& word : words) std::replace(word.begin(), word.end(), ',', '.');
  return words;
}

bool ParsePoseTable(std::string_view text,
                    const PoseColumns& columns,
                    const std::string& place,
                    RecordedTrajectory* poses,
                    std::string* error) {
  poses->clear();
  const std::vector<int> needed = NeededColumns(columns);
  const std::size_t num_needed =
      static_cast<std::size_t>(*std::max_element(needed.begin(), needed.end())) + 1;
  bool is_names = columns.has_names;
  TextLines lines(text);
  for (std::string_view line; lines.Next(&line);) {
    if (!IsContent(line)) continue;
    if (std::exchange(is_names, false)) continue;
    const Words words = SplitPoseLine(line, columns.delimiter);
    const std::string where = place + ":" + std::to_string(lines.number());
    std::string problem;
    if (columns.delimiter == '\0' && HasDecimalCommas(line, &problem)) {
      *error = where + ": " + problem;
      return false;
    }
    if (words.size() < num_needed) {
      *error = where + ": expected at least " + std::to_string(num_needed) + " columns, found " +
               std::to_string(words.size());
      return false;
    }
    int bad = -1;
    int too_large = -1;
    if (!SetPose(words, columns, &poses->emplace_back(), &bad, &too_large)) {
      *error = where + ": expected " +
               (bad == columns.stamp ? "a stamp within 146 years of zero" : "a finite number") +
               " in column " + std::to_string(bad + 1) + ", found " +
               Quoted(words[static_cast<std::size_t>(bad)]);
      return false;
    }
    if (too_large >= 0) {
      *error = where + ": expected angles in radians, found " +
               Quoted(words[static_cast<std::size_t>(too_large)]) + " in column " +
               std::to_string(too_large + 1) + ": degrees? Say so in its name, as in yaw_deg";
      return false;
    }
    if (!CheckPose(poses->back(), &problem)) {
      *error = where + ": " + problem;
      return false;
    }
  }
  if (poses->empty()) *error = place + ": holds no poses";
  return !poses->empty();
}

}  // namespace radive
