// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "radive/io/points/raw_layout.h"
#include "radive/io/scans/input_options.h"
#include "radive/io/scans/point_folder_source.h"

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

// HeRCULES Aeva: records of 29 bytes, or of 25 in recordings up to the stamp
// 1691936557946849179 ns. What the size of a file divides by decides, the stamp where it divides by
// both or neither.
class AevaFileReader : public PointFileReader {
 public:
  AevaFileReader();
  bool Read(std::string_view bytes,
            std::int64_t stamp_ns,
            PointTable* table,
            std::vector<std::string>* remarks,
            std::string* error) override;

 private:
  RawFileReader reader29_;
  RawFileReader reader25_;
};

// A folder with one raw file a scan, columns by input.layout; positions FLU [m]. `options` must be
// valid. Null, with the place and the expectation in `error`, when `path` holds no scans.
std::unique_ptr<ScanSource> OpenRawSource(const std::filesystem::path& path,
                                          const InputOptions& options,
                                          std::string* error);

// Continental ARS548 scans of HeRCULES: <stamp in ns>.bin with layout hercules29, in
// Radar/Continental or in any folder called Continental.
std::unique_ptr<ScanSource> OpenHerculesSource(const std::filesystem::path& path,
                                               const InputOptions& options,
                                               std::string* error);

}  // namespace radive
