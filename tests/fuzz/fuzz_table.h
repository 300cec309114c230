// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/scans/point_converter.h"

namespace radive::testing {

// Takes the table of a parser through the conversion to returns, which reads every byte of it that
// counts. Stops the fuzzer when the table is larger than `most_points`, what the file can hold.
inline void ConvertFuzzedTable(const PointTable& table, std::size_t most_points) {
  if (table.num_points > most_points) std::abort();
  PointConverter converter{InputOptions()};
  RadarScan scan;
  std::string error;
  const bool ok = converter.Convert(table, &scan, &error);
  if (ok ? scan.returns.size() != table.num_points : error.empty()) std::abort();
}

// Parses `data` with one of the parsers of point files, and converts what comes out.
using PointParser = bool (*)(std::string_view bytes,
                             PointTable* table,
                             std::vector<std::string>* remarks,
                             std::string* error);
inline int FuzzPointParser(PointParser parse,
                           const std::uint8_t* data,
                           std::size_t size,
                           std::size_t most_points_a_byte = 1) {
  // A copy of exactly this size: reading beyond it is noticed.
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  PointTable table;
  std::vector<std::string> remarks;
  std::string error;
  if (parse(bytes, &table, &remarks, &error)) {
    ConvertFuzzedTable(table, size * most_points_a_byte);
  } else if (error.empty()) {
    std::abort();
  }
  return 0;
}

}  // namespace radive::testing
