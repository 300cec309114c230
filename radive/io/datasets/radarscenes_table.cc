// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/radarscenes_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/scans/scan_stamps.h"

namespace radive {
namespace {

enum ScanColumn { kScanTime, kFirstPoint, kNumPoints, kNumScanColumns };
constexpr std::array<std::string_view, kNumScanColumns> kColumnNames = {
    "timestamp_rad", "first_point", "num_points"};

// The cells of a line at the given positions; false when the line ends before one of them.
bool TakeCells(std::string_view line,
               const std::array<int, kNumScanColumns>& positions,
               std::array<std::string_view, kNumScanColumns>* cells) {
  int num_found = 0;
  for (int position = 0; num_found < kNumScanColumns; ++position) {
    const std::size_t comma = line.find(',');
    for (std::size_t c = 0; c < kNumScanColumns; ++c) {
      if (positions[c] != position) continue;
      (*cells)[c] = TrimBlanks(line.substr(0, comma));
      ++num_found;
    }
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  return num_found == kNumScanColumns;
}

// Position of each column in the line of names; false when one is absent or there twice.
bool FindColumns(std::string_view header, std::array<int, kNumScanColumns>* positions) {
  positions->fill(-1);
  for (int position = 0;; ++position) {
    const std::size_t comma = header.find(',');
    const std::string_view name = TrimBlanks(header.substr(0, comma));
    for (std::size_t c = 0; c < kNumScanColumns; ++c) {
      if (name != kColumnNames[c]) continue;
      if ((*positions)[c] >= 0) return false;
      (*positions)[c] = position;
    }
    if (comma == std::string_view::npos) break;
    header.remove_prefix(comma + 1);
  }
  return *std::min_element(positions->begin(), positions->end()) >= 0;
}

}  // namespace

bool ParseRadarScenesTable(std::string_view text,
                           const std::string& place,
                           std::vector<RadarScenesScan>* scans,
                           std::string* error) {
  TextLines lines(text);
  std::string_view line;
  std::array<int, kNumScanColumns> positions;
  if (!lines.Next(&line) || !FindColumns(line, &positions)) {
    *error = place + ":1: expected the names of the columns, among them once each " +
             "timestamp_rad, first_point and num_points, found " + Quoted(line);
    return false;
  }
  while (lines.Next(&line)) {
    if (TrimBlanks(line).empty()) continue;
    std::array<std::string_view, kNumScanColumns> cells;
    const bool complete = TakeCells(line, positions, &cells);
    const auto stamp = complete ? ParseStamp(cells[kScanTime]) : std::nullopt;
    const auto first = complete ? ParseInteger(cells[kFirstPoint]) : std::nullopt;
    const auto count = complete ? ParseInteger(cells[kNumPoints]) : std::nullopt;
    if (!stamp || !first || !count || *first < 0 || *count < 0) {
      *error = place + ":" + std::to_string(lines.number()) +
               ": expected seconds in timestamp_rad and whole numbers from 0 in first_point and " +
               "num_points, found " + Quoted(line);
      return false;
    }
    scans->push_back({*stamp,
                      static_cast<std::uint64_t>(*first),
                      static_cast<std::uint64_t>(*count),
                      lines.number()});
  }
  if (!scans->empty()) return true;
  *error = place + ": expected a line a scan after the names of the columns, found none";
  return false;
}

}  // namespace radive
