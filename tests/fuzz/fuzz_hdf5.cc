// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// radar_data.h5 of RadarScenes, detections and odometry. What libhdf5 itself makes of damaged files
// happens in a child process, see hdf5_table.h, and ends there.

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "radive/io/datasets/radarscenes_hdf5.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = memfd_create("fuzz.h5", 0);
  if (file < 0 || ftruncate(file, 0) != 0 ||
      pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) {
    std::abort();
  }
  const std::string path = "/proc/self/fd/" + std::to_string(file);
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
