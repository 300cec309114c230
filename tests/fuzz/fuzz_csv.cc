// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdlib>
#include <string>

#include "radive/io/points/csv_drive.h"
#include "radive/io/points/csv_points.h"
#include "tests/fuzz/fuzz_table.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  // The table of a whole drive has a scan for each value of a column, and no line twice.
  if (const auto drive = radive::SplitCsvDrive(text)) {
    std::size_t length = drive->head.size();
    for (const radive::CsvScan& scan : drive->scans) {
      for (const std::string_view lines : scan.lines) length += lines.size();
    }
    if (drive->scans.size() < 2 || length > size) std::abort();
  }
  return radive::testing::FuzzPointParser(radive::ParseCsvPoints, data, size);
}
