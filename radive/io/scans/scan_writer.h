// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "radive/sensor/radar_scan.h"

namespace radive {

// Writes a drive, scan by scan, in a form that OpenScanSource() reads.
class ScanWriter {
 public:
  virtual ~ScanWriter() = default;

  // False, with the file and the reason in `error`, when the scan cannot be written.
  virtual bool Add(const RadarScan& scan, std::string* error) = 0;

  // After the last scan: completes the files.
  virtual bool Finish(std::string* error) = 0;
};

}  // namespace radive
