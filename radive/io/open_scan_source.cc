// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open_scan_source.h"

#include <glog/logging.h>

#include "radive/io/radarscenes_source.h"
#include "radive/io/raw_source.h"

namespace radive {

std::unique_ptr<ScanSource> OpenScanSource(const std::string& path,
                                           const InputOptions& options,
                                           std::string* error) {
  CHECK(error != nullptr);
  if (!options.IsValid(error)) return nullptr;
  switch (options.format) {
    case InputOptions::Format::kRaw:
      return OpenRawSource(path, options, error);
    case InputOptions::Format::kHercules:
      return OpenHerculesSource(path, options, error);
    case InputOptions::Format::kRadarScenes:
      return RadarScenesSource::Open(path, options, error);
  }
  LOG(FATAL) << "unknown input format";
  return nullptr;
}

}  // namespace radive
