// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radive/io/scans/source_facts.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// A drive, scan by scan. The only thing odometry knows of a dataset.
//
//   std::unique_ptr<ScanSource> source = OpenScanSource(path, options, &error);
//   RadarScan scan;
//   while (source->Next(&scan) == ScanSource::Status::kScan) { ... }
//
// Canonical form: positions FLU in metres, Doppler as range rate (positive receding) in m/s,
// integer-nanosecond stamps. Readers convert to it; nobody else does.
class ScanSource {
 public:
  enum class Status {
    kScan,   // *scan is the next scan, in stored order; it may be empty
    kEnd,    // the drive is over
    kError,  // the drive cannot be read any further: error() says file, place and expectation
  };

  virtual ~ScanSource() = default;

  virtual Status Next(RadarScan* scan) = 0;

  // As Next(), but only the stamp and the place of the scan are needed: sources that can seek do
  // not read the returns, so warnings on these are not raised either.
  virtual Status PassOver(RadarScan* scan) { return Next(scan); }

  // When the scan given last was recorded, where the container says so [ns].
  virtual std::optional<std::int64_t> record_ns() const { return std::nullopt; }

  // Passes over the next `count` scans, as if they had been read; stamps and numbering of the
  // scans behind them stay those of the whole drive. kScan: all were passed over (the next one may
  // be the end); kEnd: the drive was over before; kError: as Next().
  virtual Status Skip(int count) {
    RadarScan dropped;
    for (int i = 0; i < count; ++i) {
      const Status status = PassOver(&dropped);
      if (status != Status::kScan) return status;
    }
    return Status::kScan;
  }

  // What the source reads, for the log: "raw float32 scans (xyz3), 396 files".
  virtual std::string Description() const = 0;

  // Number of scans of the whole drive, where it is known beforehand (for progress and ETA).
  virtual std::optional<int> NumScans() const = 0;

  // What was found on opening and in the scans read so far, for reports.
  virtual SourceFacts Facts() const {
    SourceFacts facts;
    facts.format = Description();
    return facts;
  }

  // Set after Status::kError.
  const std::string& error() const { return error_; }

  // Counted remarks on scans that were delivered all the same: "FILE: 3 bytes after the last
  // whole record ignored". Cleared by TakeWarnings().
  std::vector<std::string> TakeWarnings() { return std::exchange(warnings_, {}); }

 protected:
  // Takes over the warnings of a source that this one reads from, and its error after kError.
  Status PassOn(Status status, ScanSource* source) {
    for (std::string& warning : source->TakeWarnings()) warnings_.push_back(std::move(warning));
    if (status == Status::kError) error_ = source->error();
    return status;
  }

  std::string error_;
  std::vector<std::string> warnings_;
};

}  // namespace radive
