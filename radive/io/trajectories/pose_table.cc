// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/pose_table.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <utility>

#include "radive/geometry/roll_pitch_yaw.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/trajectories/check_poses.h"
#include "radive/io/trajectories/pose_text.h"

namespace radive {
namespace {

using Names = std::vector<std::string_view>;

// How far the squared length of a quaternion in a file may be from 1.
constexpr double kUnitTolerance = 0.01;

// Position of the first column that has one of these names; -1: there is none.
int Find(const Names& columns, std::initializer_list<std::string_view> names) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string column = LowerCase(columns[i]);
    // Units may follow in brackets, and a '#' stand in front.
    const std::string_view word = std::string_view(column).substr(column[0] == '#' ? 1 : 0);
    const std::string_view name = word.substr(0, word.find_first_of("[("));
    if (std::find(names.begin(), names.end(), name) != names.end()) return static_cast<int>(i);
  }
  return -1;
}

bool IsThere(int column) { return column >= 0; }

// The columns that every line must have.
std::vector<int> NeededColumns(const PoseColumns& columns) {
  std::vector<int> needed;
  const auto add = [&needed](const auto& group) {
    std::copy_if(group.begin(), group.end(), std::back_inserter(needed), &IsThere);
  };
  add(std::array<int, 1>{columns.stamp});
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

bool SetStamp(std::string_view text, int exponent, RecordedPose* pose) {
  const int unit = LooksLikeNanoseconds(text) && exponent == 0 ? -9 : exponent;
  const std::optional<std::int64_t> stamp_ns = ParseStamp(text, unit);
  const std::optional<double> value = ParseFinite(text);
  if (!stamp_ns || !value) return false;
  pose->stamp_ns = *stamp_ns;
  pose->stamp_s = unit == 0 ? *value : *value / std::pow(10.0, -unit);
  return true;
}

// One line to a pose; its columns are there. False when one is no finite number, which `bad` is.
bool SetPose(const Names& words, const PoseColumns& columns, RecordedPose* pose, int* bad) {
  const auto value = [&](int column) {
    if (column < 0) return 0.0;
    const std::optional<double> number = ParseFinite(words[static_cast<std::size_t>(column)]);
    if (!number) *bad = column;
    return number.value_or(0.0);
  };
  *bad = -1;
  const std::array<int, 3>& p = columns.position;
  pose->T_world_body.translation << value(p[0]), value(p[1]), value(p[2]);
  const std::array<int, 4>& q = columns.quaternion;
  if (IsThere(q[0])) {
    SetRotation(value(q[3]), value(q[0]), value(q[1]), value(q[2]), pose);
  } else {
    const std::array<int, 3>& a = columns.angles;
    pose->T_world_body.rotation =
        RotationOfAngles({value(a[0]), value(a[1]), value(a[2])}, columns.angles_are_passive);
  }
  if (IsThere(columns.stamp) &&
      !SetStamp(words[static_cast<std::size_t>(columns.stamp)], columns.stamp_exponent, pose)) {
    *bad = columns.stamp;
  }
  return *bad < 0;
}

bool IsContent(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kColumnSeparators);
  return first != std::string_view::npos && line[first] != '#';
}

std::optional<PoseColumns> ColumnsByName(const Names& names) {
  PoseColumns columns;
  columns.stamp = Find(names, {"timestamp", "time", "t", "stamp", "sec", "t_ns"});
  columns.position = {Find(names, {"x", "tx", "px", "p_x", "pos_x"}),
                      Find(names, {"y", "ty", "py", "p_y", "pos_y"}),
                      Find(names, {"z", "tz", "pz", "p_z", "pos_z"})};
  columns.quaternion = {Find(names, {"qx", "q_x", "q_rs_x"}),
                        Find(names, {"qy", "q_y", "q_rs_y"}),
                        Find(names, {"qz", "q_z", "q_rs_z"}),
                        Find(names, {"qw", "q_w", "q_rs_w"})};
  if (NeededColumns(columns).size() != 8) return std::nullopt;
  return columns;
}

// The first column behind the position with which four begin that have length 1 in all lines.
std::optional<PoseColumns> ColumnsByNumbers(std::string_view text) {
  std::vector<bool> can_begin;
  TextLines lines(text);
  for (std::string_view line; lines.Next(&line);) {
    if (!IsContent(line)) continue;
    const Names words = SplitColumns(line);
    if (can_begin.empty()) can_begin.assign(words.size(), true);
    for (std::size_t i = 0; i < can_begin.size(); ++i) {
      double squared_length = 0.0;
      for (std::size_t k = i; k < i + 4; ++k) {
        const std::optional<double> number =
            k < words.size() ? ParseFinite(words[k]) : std::nullopt;
        squared_length += number ? *number * *number : HUGE_VAL;
      }
      if (!(std::abs(squared_length - 1.0) < kUnitTolerance)) can_begin[i] = false;
    }
  }
  constexpr std::size_t kBehindPosition = 4;
  for (std::size_t i = kBehindPosition; i < can_begin.size(); ++i) {
    if (!can_begin[i]) continue;
    const int q = static_cast<int>(i);
    PoseColumns columns;
    columns.stamp = 0;
    columns.position = {1, 2, 3};
    columns.quaternion = {q, q + 1, q + 2, q + 3};
    return columns;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PoseColumns> RadarScenesColumns(std::string_view names) {
  const Names words = SplitColumns(names);
  PoseColumns columns;
  columns.has_names = true;
  columns.stamp = Find(words, {"timestamp_odom"});
  columns.position = {Find(words, {"x"}), Find(words, {"y"}), -1};
  columns.angles = {-1, -1, Find(words, {"yaw"})};
  if (NeededColumns(columns).size() != 4) return std::nullopt;
  return columns;
}

PoseColumns BoreasColumns() {
  PoseColumns columns;
  columns.has_names = true;
  columns.stamp = 0;
  columns.stamp_exponent = -6;
  columns.position = {1, 2, 3};
  columns.angles = {7, 8, 9};
  columns.angles_are_passive = true;
  return columns;
}

PoseColumns ColoRadarColumns() {
  PoseColumns columns;
  columns.position = {0, 1, 2};
  columns.quaternion = {3, 4, 5, 6};
  return columns;
}

std::optional<PoseColumns> FindPoseColumns(std::string_view text,
                                           const std::string& place,
                                           std::string* error) {
  TextLines lines(text);
  std::string_view first;
  while (lines.Next(&first) && SplitColumns(first).empty()) {
  }
  if (HoldsNamesOnly(first)) {
    std::optional<PoseColumns> columns = ColumnsByName(SplitColumns(first));
    if (columns) {
      columns->has_names = IsContent(first);
      return columns;
    }
    if (IsContent(first)) {
      *error = place + ":" + std::to_string(lines.number()) +
               ": expected the names of the columns, among them a stamp, x y z and qx qy qz qw, "
               "found " +
               Quoted(first);
      return std::nullopt;
    }
  }
  if (const std::optional<PoseColumns> columns = ColumnsByNumbers(text)) return columns;
  *error = place +
           ": expected lines 't x y z qx qy qz qw', perhaps with other columns between, but no "
           "four columns in a row behind the first four have length 1 in all lines";
  return std::nullopt;
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
    const Names words = SplitColumns(line);
    const std::string where = place + ":" + std::to_string(lines.number());
    std::string problem;
    if (HasDecimalCommas(line, &problem)) {
      *error = where + ": " + problem;
      return false;
    }
    if (words.size() < num_needed) {
      *error = where + ": expected at least " + std::to_string(num_needed) + " columns, found " +
               std::to_string(words.size());
      return false;
    }
    int bad = -1;
    if (!SetPose(words, columns, &poses->emplace_back(), &bad)) {
      *error = where + ": expected a finite number in column " + std::to_string(bad + 1) +
               ", found " + Quoted(words[static_cast<std::size_t>(bad)]);
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
