// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace radive {

// A field of the stored points and what values it had, for reports.
struct FieldSummary {
  std::string name;
  std::string type;  // "float32"
  std::string role;  // "doppler"; empty: not used
  double min = 0.0;  // of the finite values; min > max: there were none
  double max = 0.0;
  std::size_t num_values = 0;
  std::size_t num_not_finite = 0;
};

// What a source found, for reports. Whatever it does not know stays empty.
struct SourceFacts {
  std::string format;        // "PCD", "rosbag1"
  std::string place;         // folder, or bag and topic
  std::string stamp_origin;  // "times.txt", "header stamps"
  std::string axes;          // "+x+y+z, because ..."
  std::string why_no_drive;  // why these scans are no drive to run over; empty: they may be one
  std::vector<FieldSummary> fields;     // of the scans read so far, the first few
  std::vector<std::int64_t> stamps_ns;  // of the whole drive, where known without reading it [ns]
};

}  // namespace radive
