// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace radive {

// A line of radarK_scans.csv: which rows of the file of points a scan has.
struct RadarScenesScan {
  std::int64_t stamp_ns = 0;  // [ns]
  std::uint64_t first_point = 0;
  std::uint64_t num_points = 0;
  int line = 0;  // in the table, from 1
};

// Reads the columns timestamp_rad (decimal seconds), first_point and num_points, found by the names
// in the first line; the others hold ground truth and are not looked at. False, with "PLACE:LINE:
// what was expected, what was found" in `error`, when a line has none of them or there is no scan.
bool ParseRadarScenesTable(std::string_view text,
                           const std::string& place,
                           std::vector<RadarScenesScan>* scans,
                           std::string* error);

}  // namespace radive
