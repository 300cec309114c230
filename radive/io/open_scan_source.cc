// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open_scan_source.h"

#include <glog/logging.h>

#include "radive/io/bag/bag_source.h"
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
    case InputOptions::Format::kRosbag1:
      return BagSource::Open(path, BagFormat::kRosbag1, options, error);
    case InputOptions::Format::kRosbag2:
      return BagSource::Open(path, BagFormat::kRosbag2, options, error);
    case InputOptions::Format::kMcap:
      return BagSource::Open(path, BagFormat::kMcap, options, error);
  }
  LOG(FATAL) << "unknown input format";
  return nullptr;
}

}  // namespace radive
