// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/points/raw_layout.h"
#include "radive/io/scans/input_options.h"
#include "radive/io/scans/point_folder_source.h"
#include "radive/io/scans/scan_folder.h"

namespace radive {

// Reads plain arrays of little-endian records whose columns the layout tells, because the files do
// not. Records that state their range twice, as a column and as |x y z|, are checked for it.
class RawFileReader : public PointFileReader {
 public:
  explicit RawFileReader(RawLayout layout);
  bool Read(std::string_view bytes,
            std::int64_t stamp_ns,
            PointTable* table,
            std::vector<std::string>* remarks,
            std::string* error) override;

 private:
  const RawLayout layout_;
  bool states_range_twice_ = false;
  FieldMatch match_;
};

// Where raw scans are looked for: in options.folder, or in the usual folders and in `more_folders`.
ScanFolderQuery RawFolders(const InputOptions& options,
                           const std::vector<std::string>& more_folders);

// The scans that `query` finds at `path`, read by `reader`; `description` for reports. Null, with
// the place and the expectation in `error`, when there are none.
std::unique_ptr<ScanSource> OpenRawFiles(const std::filesystem::path& path,
                                         const ScanFolderQuery& query,
                                         std::unique_ptr<PointFileReader> reader,
                                         const InputOptions& options,
                                         const std::string& description,
                                         std::string* error);

// A folder with one raw file a scan, columns by input.layout; positions FLU [m]. `options` must be
// valid. Null, with the place and the expectation in `error`, when `path` holds no scans.
std::unique_ptr<ScanSource> OpenRawSource(const std::filesystem::path& path,
                                          const InputOptions& options,
                                          std::string* error,
                                          const std::vector<std::string>& more_folders = {});

}  // namespace radive
