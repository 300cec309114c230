// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/raw_source.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "radive/io/bytes/record_file.h"

namespace radive {
namespace {

// Number of records whose stored range is not |x y z|.
std::size_t CountContradictions(const PointTable& table, const FieldMatch& match) {
  const auto value = [&](std::size_t i, FieldRole role) {
    const PointField& field = table.fields[static_cast<std::size_t>(match[role])];
    return ReadNumber(table.data + i * table.stride + field.offset, field.type, false);
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < table.num_points; ++i) {
    const double range = value(i, FieldRole::kRange);
    const Eigen::Vector3d position(
        value(i, FieldRole::kX), value(i, FieldRole::kY), value(i, FieldRole::kZ));
    const double difference = std::abs(range - position.norm());
    count += difference > 0.01 * std::max(1.0, std::abs(range)) ? 1 : 0;
  }
  return count;
}

}  // namespace

RawFileReader::RawFileReader(RawLayout layout) : layout_(std::move(layout)) {
  std::string error;
  const std::optional<FieldMatch> match = MatchFields(layout_.fields, {}, &error);
  CHECK(match) << error;
  match_ = *match;
  states_range_twice_ = match_.Has(FieldRole::kRange) && match_.Has(FieldRole::kX) &&
                        match_.Has(FieldRole::kY) && match_.Has(FieldRole::kZ);
}

bool RawFileReader::Read(std::string_view bytes,
                         std::int64_t /*stamp_ns*/,
                         PointTable* table,
                         std::vector<std::string>* remarks,
                         std::string* /*error*/) {
  table->fields = layout_.fields;
  table->stride = layout_.record_size;
  table->num_points = static_cast<std::size_t>(
      CountRecords(bytes.size(), table->stride, "layout " + layout_.name, remarks));
  table->data = bytes.data();
  if (!states_range_twice_) return true;
  // A file of another kind shows here.
  const std::size_t num_contradictions = CountContradictions(*table, match_);
  if (2 * num_contradictions > table->num_points) {
    remarks->push_back("the stored range is not |x y z| in " + std::to_string(num_contradictions) +
                       " of " + std::to_string(table->num_points) +
                       " records; these may be no records of layout " + layout_.name);
  }
  return true;
}

ScanFolderQuery RawFolders(const InputOptions& options,
                           const std::vector<std::string>& more_folders) {
  ScanFolderQuery query;
  query.candidates = {".", "radar", "velodyne", "training/velodyne", "radar/training/velodyne"};
  query.candidates.insert(query.candidates.end(), more_folders.begin(), more_folders.end());
  if (!options.folder.empty()) query.LookOnlyIn(options.folder);
  query.rate = options.rate;
  return query;
}

std::unique_ptr<ScanSource> OpenRawFiles(const std::filesystem::path& path,
                                         const ScanFolderQuery& query,
                                         std::unique_ptr<PointFileReader> reader,
                                         const InputOptions& options,
                                         const std::string& description,
                                         std::string* error) {
  std::optional<ScanFolder> folder = OpenScanFolder(path, query, error);
  if (!folder) return nullptr;
  return std::make_unique<PointFolderSource>(
      *std::move(folder), std::move(reader), options, description);
}

std::unique_ptr<ScanSource> OpenRawSource(const std::filesystem::path& path,
                                          const InputOptions& options,
                                          std::string* error,
                                          const std::vector<std::string>& more_folders) {
  if (options.layout.empty()) {
    *error = path.string() +
             ": raw files do not tell their columns; set input.layout, see --help_config";
    return nullptr;
  }
  return OpenRawFiles(path,
                      RawFolders(options, more_folders),
                      std::make_unique<RawFileReader>(KnownLayout(options.layout)),
                      options,
                      "raw float32 scans (" + options.layout + ")",
                      error);
}

}  // namespace radive
