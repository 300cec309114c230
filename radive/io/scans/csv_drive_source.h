// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/points/csv_drive.h"
#include "radive/io/scans/input_options.h"
#include "radive/io/scans/point_converter.h"
#include "radive/io/scans/scan_source.h"

namespace radive {

// A drive in one text table, whose column of times or of frames tells the scans apart.
class CsvDriveSource : public ScanSource {
 public:
  // Null when the table holds one scan, and when it cannot be read. The unit of the times is found
  // as in ReadStampSequence(); frames, and times that only count, follow input.rate.
  static std::unique_ptr<CsvDriveSource> Open(const std::filesystem::path& file,
                                              const InputOptions& options);

  Status Next(RadarScan* scan) override;
  Status PassOver(RadarScan* scan) override;
  std::string Description() const override;
  std::optional<int> NumScans() const override;
  SourceFacts Facts() const override;

 private:
  CsvDriveSource(const std::filesystem::path& file, const InputOptions& options)
      : file_(file), converter_(options) {}

  void StampFrames(double rate);

  const std::filesystem::path file_;
  PointConverter converter_;
  std::string text_;
  CsvDrive drive_;  // its views refer to text_
  std::vector<std::int64_t> stamps_ns_;
  std::string stamp_origin_;
  std::size_t next_ = 0;
  std::string content_;  // of one scan, kept for its memory
};

}  // namespace radive
