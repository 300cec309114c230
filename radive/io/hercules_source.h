// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "radive/io/input_options.h"
#include "radive/io/record_folder_source.h"

namespace radive {

// Continental ARS548 scans of HeRCULES: <stamp in ns>.bin in Radar/Continental, or in any folder of
// that name, with packed little-endian records of 29 bytes:
//
//   offset  0  4  8   float32  x y z, FLU [m]
//          12         float32  radial velocity [m/s]
//          16         float32  range [m]
//          20         int8     radar cross section [dBsm] -> power
//          21 25      float32  azimuth, elevation [rad]
class HerculesSource : public RecordFolderSource {
 public:
  // `options` must be valid. Null, with the place and the expectation in `error`, when `path` holds
  // no such scans.
  static std::unique_ptr<HerculesSource> Open(const std::filesystem::path& path,
                                              const InputOptions& options,
                                              std::string* error);

 protected:
  void Decode(std::string_view records, RadarScan* scan) override;

 private:
  HerculesSource(ScanFolder folder, const InputOptions& options);

  const double doppler_sign_;
};

}  // namespace radive
