// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/open/open_scan_source.h"

#include <glog/logging.h>

#include <optional>
#include <utility>
#include <vector>

#include "radive/io/bags/bag_source.h"
#include "radive/io/datasets/dataset.h"
#include "radive/io/open/all_radars.h"
#include "radive/io/open/detect_format.h"
#include "radive/io/scans/axes.h"
#include "radive/io/scans/merged_source.h"
#include "radive/io/scans/ordered_source.h"
#include "radive/io/scans/point_file_source.h"
#include "radive/io/scans/raw_source.h"

namespace radive {
namespace {

using Format = InputOptions::Format;

// The drive as stored, apart from its axes.
std::unique_ptr<ScanSource> OpenStored(const std::string& path,
                                       const InputOptions& options,
                                       std::string* error) {
  std::vector<std::string> folders;
  for (const Dataset& dataset : Datasets()) {
    for (const DatasetSensor& sensor : dataset.sensors) {
      if (!sensor.HasFormOf(options)) continue;
      if (sensor.open != nullptr) return sensor.open(path, options, error);
      folders.insert(folders.end(), sensor.folders.begin(), sensor.folders.end());
    }
  }
  switch (options.format) {
    case Format::kRaw:
      return OpenRawSource(path, options, error, folders);
    case Format::kPcd:
      return OpenPointFileSource(path, PointFileFormat::kPcd, options, error, folders);
    case Format::kPly:
      return OpenPointFileSource(path, PointFileFormat::kPly, options, error, folders);
    case Format::kCsv:
      return OpenPointFileSource(path, PointFileFormat::kCsv, options, error, folders);
    case Format::kNpy:
      return OpenPointFileSource(path, PointFileFormat::kNpy, options, error, folders);
    case Format::kYaml:
      return OpenPointFileSource(path, PointFileFormat::kYaml, options, error, folders);
    case Format::kRosbag1:
      return BagSource::Open(path, BagFormat::kRosbag1, options, error);
    case Format::kRosbag2:
      return BagSource::Open(path, BagFormat::kRosbag2, options, error);
    case Format::kMcap:
      return BagSource::Open(path, BagFormat::kMcap, options, error);
    case Format::kHercules:
    case Format::kRadarScenes:
    case Format::kRaFlow:
    case Format::kAuto:
      break;
  }
  LOG(FATAL) << "unknown input format";
  return nullptr;
}

std::unique_ptr<ScanSource> OpenOne(const std::string& path,
                                    const InputOptions& options,
                                    std::string* error) {
  std::unique_ptr<ScanSource> source = OpenStored(path, options, error);
  if (source == nullptr) return nullptr;
  auto ordered = std::make_unique<OrderedSource>(std::move(source));
  return std::make_unique<AxesSource>(std::move(ordered), options.axes);
}

// Each radar with axes of its own.
std::unique_ptr<ScanSource> OpenAll(const std::string& path,
                                    const InputOptions& options,
                                    std::string* error) {
  const std::optional<std::vector<RadarInput>> inputs = ListRadars(path, options, error);
  if (!inputs) return nullptr;
  std::vector<MergedSource::Radar> radars;
  for (const RadarInput& input : *inputs) {
    radars.push_back({OpenOne(path, input.options, error), input.number});
    if (radars.back().source == nullptr) return nullptr;
  }
  return std::make_unique<MergedSource>(std::move(radars));
}

}  // namespace

std::unique_ptr<ScanSource> OpenScanSource(const std::string& path,
                                           const InputOptions& options,
                                           std::string* error) {
  CHECK(error != nullptr);
  if (!options.IsValid(error)) return nullptr;
  InputOptions found = options;
  std::string reason;
  if (!DetectFormat(path, &found, &reason, error)) return nullptr;
  return options.radar == "all" ? OpenAll(path, found, error) : OpenOne(path, found, error);
}

}  // namespace radive
