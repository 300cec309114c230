// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/find_pose_columns.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "radive/io/bytes/text_lines.h"
#include "radive/io/trajectories/check_poses.h"
#include "radive/io/trajectories/pose_names.h"
#include "radive/io/trajectories/pose_text.h"

namespace radive {
namespace {

// How far the squared length of a quaternion in a file may be from 1.
constexpr double kNormTolerance = 0.01;
// ... and R R^T from the identity: files have few digits.
constexpr double kRotationTolerance = 0.02;

constexpr char kAdvice[] =
    "; name the columns in the first line, or say with reference.format (radive_evaluate --format) "
    "what they are";

// The lines in front of the numbers, and the numbers.
struct Table {
  std::vector<std::string_view> heads;  // comments and a line of names, without their signs
  std::string_view uncommented;         // the line of names, when it is no comment
  int first_line = 0;                   // with numbers
  std::string_view first;
  char delimiter = '\0';                  // see PoseColumns
  bool has_points = false;                // decimal points, anywhere
  std::vector<std::vector<double>> rows;  // NaN for what is no number
  std::size_t width = 0;                  // of each row; 0: they differ
};

char DelimiterOf(std::string_view line) {
  if (line.find(';') != std::string_view::npos) return ';';
  std::string ignored;
  return HasDecimalCommas(line, &ignored) ? ' ' : '\0';
}

Table ReadTable(std::string_view text) {
  Table table;
  TextLines lines(text);
  for (std::string_view line; lines.Next(&line);) {
    std::string_view rest = TrimBlanks(line);
    if (rest.empty()) continue;
    const bool is_comment = rest.front() == '#' || rest.front() == '%';
    if (is_comment || (table.rows.empty() && HoldsNamesOnly(line))) {
      if (!table.rows.empty()) continue;
      table.heads.push_back(rest);
      if (!is_comment) table.uncommented = rest;
      continue;
    }
    if (table.rows.empty()) {
      table.first_line = lines.number();
      table.first = line;
      table.delimiter = DelimiterOf(line);
    }
    table.has_points = table.has_points || line.find('.') != std::string_view::npos;
    std::vector<double>& row = table.rows.emplace_back();
    for (const std::string& word : SplitPoseLine(line, table.delimiter)) {
      row.push_back(ParseFinite(word).value_or(std::nan("")));
    }
    if (table.rows.size() == 1) table.width = row.size();
    if (row.size() != table.width) table.width = 0;
  }
  return table;
}

template <typename Test>
bool InAllRows(const Table& table, std::size_t end, const Test& test) {
  return table.width >= end && std::all_of(table.rows.begin(), table.rows.end(), test);
}

bool IsUnit(const Table& table, std::size_t first) {
  return InAllRows(table, first + 4, [&](const std::vector<double>& row) {
    const double* q = row.data() + first;
    return std::abs(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] - 1.0) < kNormTolerance;
  });
}

// Twelve columns that are the rows of [R | t]; `stride` between the numbers of a row and
// `row_stride` between rows tell rows from columns.
PoseColumns MatrixAt(std::size_t first, std::size_t column_step, std::size_t row_step) {
  PoseColumns columns;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      columns.matrix[4 * row + column] =
          static_cast<int>(first + row * row_step + column * column_step);
    }
  }
  return columns;
}

bool IsRotation(const Table& table, const PoseColumns& columns) {
  return InAllRows(table, 12, [&](const std::vector<double>& row) {
    Eigen::Matrix3d R;
    for (int i = 0; i < 9; ++i) {
      const int column = columns.matrix[static_cast<std::size_t>(4 * (i / 3) + i % 3)];
      R(i / 3, i % 3) = row[static_cast<std::size_t>(column)];
    }
    return (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < kRotationTolerance &&
           R.determinant() > 0.0;
  });
}

// The four numbers 0 0 0 1 at `first`, `step` columns apart.
bool IsLastRow(const Table& table, std::size_t first, std::size_t step) {
  return InAllRows(table, first + 3 * step + 1, [&](const std::vector<double>& row) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(std::abs(row[first + i * step] - (i == 3 ? 1.0 : 0.0)) < 1e-6)) return false;
    }
    return true;
  });
}

// Whole numbers that count up by one from 0 or 1.
bool IsIndex(const Table& table, std::size_t column) {
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const double start = table.rows[0][column];
    if ((start != 0.0 && start != 1.0) || table.rows[i][column] != start + static_cast<double>(i)) {
      return false;
    }
  }
  return true;
}

bool Ascends(const Table& table, std::size_t column) {
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    if (!(table.rows[i][column] > table.rows[i - 1][column])) return false;
  }
  return true;
}

// The columns in front of a matrix: none, an index or a stamp, or two of these.
bool SetStampBefore(const Table& table, std::size_t num_before, PoseColumns* columns) {
  if (num_before == 0) return true;
  if (num_before == 1) {
    if (!IsIndex(table, 0)) columns->stamp = 0;
    return true;
  }
  if (!IsIndex(table, 0)) return false;
  columns->stamp = 1;
  return Ascends(table, 1);
}

std::optional<PoseColumns> MatricesByNumbers(const Table& table) {
  for (const std::size_t num_before : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
    for (const std::size_t size : {std::size_t{12}, std::size_t{16}}) {
      if (table.width != num_before + size) continue;
      PoseColumns columns = MatrixAt(num_before, 1, 4);
      if (size == 16 && !IsLastRow(table, num_before + 12, 1)) {
        if (!IsLastRow(table, num_before + 3, 4)) continue;
        columns = MatrixAt(num_before, 4, 1);
      }
      if (IsRotation(table, columns) && SetStampBefore(table, num_before, &columns)) return columns;
    }
  }
  return std::nullopt;
}

PoseColumns QuaternionAt(int stamp, int position, int quaternion) {
  PoseColumns columns;
  columns.stamp = stamp;
  columns.position = {position, position + 1, position + 2};
  columns.quaternion = {quaternion, quaternion + 1, quaternion + 2, quaternion + 3};
  return columns;
}

std::optional<PoseColumns> QuaternionsByNumbers(const Table& table) {
  constexpr std::size_t kBehindPosition = 4;
  if (table.width == 7 && IsUnit(table, 3)) return QuaternionAt(-1, 0, 3);
  if (table.width == 8) return QuaternionAt(0, 1, 4);
  if (table.width >= 9 && IsIndex(table, 0) && Ascends(table, 1) && IsUnit(table, 5) &&
      !IsUnit(table, 4)) {
    return QuaternionAt(1, 2, 5);
  }
  for (std::size_t i = kBehindPosition; i + 4 <= table.width; ++i) {
    if (IsUnit(table, i)) return QuaternionAt(0, 1, static_cast<int>(i));
  }
  return std::nullopt;
}

// By the last of the lines in front whose names tell; their number must be that of the columns.
std::optional<PoseColumns> ByNames(const Table& table) {
  for (auto head = table.heads.rbegin(); head != table.heads.rend(); ++head) {
    const std::vector<std::string_view> names = SplitNames(*head);
    if (names.size() < table.width) continue;
    // A sign "#," or a trailing delimiter is no column.
    if (names.size() != table.width && !(names.size() == table.width + 1 && names.back().empty())) {
      continue;
    }
    std::optional<PoseColumns> columns = ColumnsByName(names);
    if (columns) return columns;
  }
  return std::nullopt;
}

std::string Widths(const Table& table) {
  return table.width == 0 ? "lines with different numbers of columns"
                          : std::to_string(table.width) + " columns";
}

}  // namespace

std::optional<PoseColumns> FindPoseColumns(std::string_view text,
                                           const std::string& place,
                                           std::string* error) {
  const Table table = ReadTable(text);
  if (table.rows.empty()) {
    *error = place + ": holds no poses";
    return std::nullopt;
  }
  const std::string where = place + ":" + std::to_string(table.first_line) + ": ";
  const auto found = [&](std::optional<PoseColumns> columns) {
    columns->delimiter = table.delimiter;
    columns->has_names = !table.uncommented.empty();
    return columns;
  };
  if (const std::optional<PoseColumns> columns = ByNames(table)) return found(columns);
  if (!table.uncommented.empty()) {
    *error = place + ":" + std::to_string(std::max(1, table.first_line - 1)) +
             ": expected a name for each of the " + Widths(table) +
             ", among them a stamp, x y z and qx qy qz qw (or roll pitch yaw), found " +
             Quoted(table.uncommented);
    return std::nullopt;
  }
  const bool is_only_commas = table.first.find(',') != std::string_view::npos &&
                              table.delimiter == '\0' && !table.has_points;
  if (is_only_commas && (table.width == 16 || table.width == 24)) {
    *error = where + Widths(table) +
             " of whole numbers between commas: are these decimal commas? " +
             "Separate the columns by semicolons, found " + Quoted(table.first);
    return std::nullopt;
  }
  if (const auto columns = MatricesByNumbers(table)) return found(columns);
  if (const auto columns = QuaternionsByNumbers(table)) return found(columns);
  if (table.width == 12) return found(MatrixAt(0, 1, 4));
  *error = where + Widths(table) +
           ", expected 8 (t x y z qx qy qz qw), 12 (rows of [R | t]) or 16 (rows of a 4x4 matrix), "
           "with an index or a stamp in front, or more of a pose; no rotation matrix and no four "
           "columns in a row of length 1 are in all lines" +
           kAdvice;
  return std::nullopt;
}

}  // namespace radive
