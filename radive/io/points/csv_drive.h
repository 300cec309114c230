// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace radive {

// One scan of a table that holds a whole drive: the lines that have the same cell in the column
// that tells the scans apart.
struct CsvScan {
  std::string_view key;                 // that cell
  std::string_view time;                // of its first line, where a column has times; else empty
  std::vector<std::string_view> lines;  // runs of whole lines, in the order of the table
};

struct CsvDrive {
  std::string column;      // that tells the scans apart
  bool has_times = false;  // it holds times; false: numbers of scans
  std::string_view head;   // the text in front of the numbers, with the names
  std::vector<CsvScan> scans;
};

// Takes a table of points of many scans apart, by its column of frames (frame, scan, sweep ...,
// with _id, _index or _number behind) or of times. Nothing when all lines have the same value
// there, when there are fewer than three lines to a value (times of single points), and when there
// is no such column. The views refer to `text`.
std::optional<CsvDrive> SplitCsvDrive(std::string_view text);

}  // namespace radive
