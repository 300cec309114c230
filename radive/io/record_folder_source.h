// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "radive/io/scan_folder.h"
#include "radive/io/scan_source.h"

namespace radive {

// What the sources have in common that read a folder with one file of fixed-size records a scan.
// A file that cannot be read becomes an empty scan and a warning, because every scan of the drive
// gets its line in the trajectory.
class RecordFolderSource : public ScanSource {
 public:
  Status Next(RadarScan* scan) final;
  Status Skip(int count) final;
  std::string Description() const final;
  std::optional<int> NumScans() const final;

 protected:
  // `record_size` in bytes; `format` and `record_name` for messages: "raw float32 scans (xyz3)",
  // "layout xyz3".
  RecordFolderSource(ScanFolder folder,
                     std::size_t record_size,
                     std::string format,
                     std::string record_name);

  // Appends the returns in `records`, a whole number of records, to `scan`, and sets what else it
  // knows of the scan. Stamp and place are set.
  virtual void Decode(std::string_view records, RadarScan* scan) = 0;

 private:
  const ScanFolder folder_;
  const std::size_t record_size_;
  const std::string format_;
  const std::string record_name_;
  std::size_t next_ = 0;
  std::string content_;  // of one file, kept for its memory
};

}  // namespace radive
