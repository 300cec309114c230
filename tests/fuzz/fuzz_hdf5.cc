// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// radar_data.h5 of RadarScenes, detections and odometry. What libhdf5 itself makes of damaged files
// happens in a child process, see hdf5_table.h, and ends there.

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "radive/io/datasets/radarscenes_hdf5.h"

// What libhdf5 does not free of files that it refuses.
extern "C" const char* __lsan_default_suppressions() { return "leak:libhdf5"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // libhdf5 takes a name, and none of /proc.
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("fuzz_hdf5_" + std::to_string(getpid()))).string();
  static const int is_to_be_removed = std::atexit([] { std::filesystem::remove(path); });
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  if (is_to_be_removed != 0) std::abort();
  std::string error;
  radive::InputOptions options;
  options.radar = "2";
  const auto source = radive::RadarScenesHdf5Source::Open(path, options, &error);
  if (source == nullptr && error.empty()) std::abort();
  if (source != nullptr) {
    radive::RadarScan scan;
    int num_scans = 0;
    while (source->Next(&scan) == radive::ScanSource::Status::kScan && num_scans < 1000) {
      ++num_scans;
    }
    if (num_scans > *source->NumScans()) std::abort();
  }
  error.clear();
  const auto poses = radive::ReadRadarScenesOdometry(path, &error);
  if (poses ? poses->empty() : error.empty()) std::abort();
  return 0;
}
