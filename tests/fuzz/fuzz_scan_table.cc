// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/datasets/radarscenes_table.h"
#include "radive/io/scans/scan_stamps.h"
#include "radive/io/scans/stamp_names.h"

// Tables beside the points: those of RadarScenes, files of stamps, and names that are stamps. The
// first byte says which.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  std::string error;
  switch (data[0] % 3) {
    case 0: {
      std::vector<radive::RadarScenesScan> scans;
      const bool ok = radive::ParseRadarScenesTable(text, "fuzz", &scans, &error);
      if (ok ? scans.empty() || scans.size() > size : error.empty()) std::abort();
      break;
    }
    case 1: {
      const bool is_trajectory = (data[0] / 3) % 2 == 1;
      const auto sequence = radive::ParseStampLines(text, is_trajectory, 0.0, "fuzz", &error);
      if (!sequence && error.empty()) std::abort();
      break;
    }
    default: {
      std::optional<std::size_t> odd;
      radive::StampsOfNames({text, "1700000000.5", text + "1"}, &odd);
      break;
    }
  }
  return 0;
}
