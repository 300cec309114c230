// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/scans/input_options.h"
#include "radive/io/scans/source_facts.h"
#include "radive/preprocessing/preprocessing_options.h"
#include "radive/sensor/sensor_options.h"

namespace radive {

// What RaDiVe understood of a drive, from its first scans.
struct InputReport {
  std::string path;
  std::string format;
  std::string layout;  // of raw files
  std::string reason;  // why this format
  SourceFacts facts;
  std::string doppler;  // the sign and its evidence
  bool has_doppler = false;
  bool is_planar = false;
  int num_scans_read = 0;
  std::optional<int> num_scans;   // of the whole drive, where known
  double returns_per_scan = 0.0;  // mean
  std::size_t num_stamps = 0;     // that the figures below rest on
  double rate = 0.0;              // from the median interval [Hz]; 0: unknown
  int num_gaps = 0;               // intervals above 1.8 times the median
  double longest_interval = 0.0;  // [s]
  int num_not_increasing = 0;     // stamps that repeat or go back
  std::vector<std::string> warnings;

  // The block for people, in lines of "name: what".
  std::string ToText() const;
  std::string ToJson() const;
};

// Opens the drive at `path`, reads its first scans, compares their Doppler with the motion of
// their points, and says what is there. Nothing, with the source's own message in `error`, when it
// does not open or cannot be read.
std::optional<InputReport> InspectInput(const std::string& path,
                                        const InputOptions& options,
                                        const SensorOptions& sensor,
                                        const PreprocessingOptions& preprocessing,
                                        std::string* error);

}  // namespace radive
