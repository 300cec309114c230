// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/scans/input_options.h"
#include "radive/io/scans/point_converter.h"
#include "radive/io/scans/scan_folder.h"
#include "radive/io/scans/scan_source.h"

namespace radive {

// Takes the bytes of a file with the points of one scan apart.
class PointFileReader {
 public:
  virtual ~PointFileReader() = default;

  // Fills `table`; it may refer to `bytes`. Appends remarks on what was left out to `remarks`.
  // False, with the place in the file and the expectation in `error`, when there are no points to
  // be had. `stamp_ns` is the scan's.
  virtual bool Read(std::string_view bytes,
                    std::int64_t stamp_ns,
                    PointTable* table,
                    std::vector<std::string>* remarks,
                    std::string* error) = 0;
};

// A folder with one file of points a scan, of any format. A file that cannot be parsed becomes an
// empty scan and a warning, because every scan of the drive gets its line in the trajectory. When
// none of the first files can, that is an error; so is a file that the disk does not give, or that
// has been cut since the folder was opened.
class PointFolderSource : public ScanSource {
 public:
  // `options` must be valid; `format` for reports: "raw float32 scans (xyz3)".
  PointFolderSource(ScanFolder folder,
                    std::unique_ptr<PointFileReader> reader,
                    const InputOptions& options,
                    std::string format);

  Status Next(RadarScan* scan) override;
  Status PassOver(RadarScan* scan) override;
  std::string Description() const override;
  std::optional<int> NumScans() const override;
  SourceFacts Facts() const override;

 private:
  bool ReadReturns(RadarScan* scan, std::vector<std::string>* remarks, std::string* reason);
  bool CanReadOneOfTheNext();
  bool ReadFile(std::size_t index, std::string* reason);

  const ScanFolder folder_;
  std::vector<std::uintmax_t> sizes_;  // of the files when the folder was opened [bytes]
  const std::unique_ptr<PointFileReader> reader_;
  const std::string format_;
  PointConverter converter_;
  bool is_unreadable_ = false;  // the last file, which says nothing of its content
  std::size_t next_ = 0;
  std::string content_;      // of one file, kept for its memory
  bool has_looked_ = false;  // whether the files can be read at all
};

}  // namespace radive
