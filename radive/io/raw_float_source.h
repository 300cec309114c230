// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "radive/io/input_options.h"
#include "radive/io/raw_layout.h"
#include "radive/io/record_folder_source.h"

namespace radive {

// A folder with one file a scan, each a plain array of little-endian float32 records whose columns
// the user declares (input.layout): View-of-Delft, TJ4DRadSet, ... Positions FLU [m].
class RawFloatSource : public RecordFolderSource {
 public:
  // `options` must be valid. Null, with the place and the expectation in `error`, when `path` holds
  // no scans.
  static std::unique_ptr<RawFloatSource> Open(const std::filesystem::path& path,
                                              const InputOptions& options,
                                              std::string* error);

 protected:
  void Decode(std::string_view records, RadarScan* scan) override;

 private:
  RawFloatSource(ScanFolder folder, const RawLayout& layout, const InputOptions& options);

  const RawLayout layout_;
  const double doppler_sign_;
  const bool planar_;
};

}  // namespace radive
