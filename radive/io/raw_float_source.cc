// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/raw_float_source.h"

#include <glog/logging.h>

#include <cstddef>
#include <utility>

#include "radive/io/record_file.h"

namespace radive {
namespace {

double Column(const char* record, int column) {
  return static_cast<double>(ReadFloat32(record + 4 * static_cast<std::ptrdiff_t>(column)));
}

}  // namespace

std::unique_ptr<RawFloatSource> RawFloatSource::Open(const std::filesystem::path& path,
                                                     const InputOptions& options,
                                                     std::string* error) {
  const std::optional<RawLayout> layout = ParseRawLayout(options.layout, error);
  CHECK(layout) << "input options were not checked: " << *error;
  ScanFolderQuery query;
  query.candidates = {".", "radar", "velodyne", "training/velodyne", "radar/training/velodyne"};
  if (!options.folder.empty()) query.candidates = {options.folder};
  query.rate = options.rate;
  std::optional<ScanFolder> folder = OpenScanFolder(path, query, error);
  if (!folder) return nullptr;
  return std::unique_ptr<RawFloatSource>(new RawFloatSource(*std::move(folder), *layout, options));
}

RawFloatSource::RawFloatSource(ScanFolder folder,
                               const RawLayout& layout,
                               const InputOptions& options)
    : RecordFolderSource(std::move(folder),
                         layout.record_size(),
                         "raw float32 scans (" + layout.name + ")",
                         "layout " + layout.name),
      layout_(layout),
      doppler_sign_(options.FixedDopplerSign()),
      planar_(options.planar || layout.z < 0) {}

void RawFloatSource::Decode(std::string_view records, RadarScan* scan) {
  scan->has_doppler = layout_.doppler >= 0;
  scan->is_planar = planar_;
  for (std::size_t i = 0; i < records.size(); i += layout_.record_size()) {
    const char* const record = records.data() + i;
    RadarReturn& added = scan->returns.emplace_back();
    added.position.x() = Column(record, layout_.x);
    added.position.y() = Column(record, layout_.y);
    if (!planar_) added.position.z() = Column(record, layout_.z);
    if (layout_.doppler >= 0) added.doppler = doppler_sign_ * Column(record, layout_.doppler);
    if (layout_.power >= 0) added.power = Column(record, layout_.power);
  }
}

}  // namespace radive
