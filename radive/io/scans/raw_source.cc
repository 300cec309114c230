// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/raw_source.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

constexpr char kAevaLayout[] = "aeva";
// Recordings with 25 bytes end in August 2023; stamps before 2019 are of another clock [ns].
constexpr std::int64_t kFirstStampOf25Bytes = 1546300800000000000;
constexpr std::int64_t kLastStampOf25Bytes = 1691936557946849179;

RawLayout LayoutOf(const std::string& text) {
  std::string error;
  std::optional<RawLayout> layout = ParseRawLayout(text, &error);
  CHECK(layout) << "input options were not checked: " << error;
  return *std::move(layout);
}

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

AevaFileReader::AevaFileReader() : reader29_(LayoutOf("aeva29")), reader25_(LayoutOf("aeva25")) {}

bool AevaFileReader::Read(std::string_view bytes,
                          std::int64_t stamp_ns,
                          PointTable* table,
                          std::vector<std::string>* remarks,
                          std::string* error) {
  const bool fits29 = bytes.size() % 29 == 0;
  const bool fits25 = bytes.size() % 25 == 0;
  const bool is_old = stamp_ns >= kFirstStampOf25Bytes && stamp_ns <= kLastStampOf25Bytes;
  const bool is29 = fits29 != fits25 ? fits29 : !is_old;
  return (is29 ? reader29_ : reader25_).Read(bytes, stamp_ns, table, remarks, error);
}

std::unique_ptr<ScanSource> OpenRawSource(const std::filesystem::path& path,
                                          const InputOptions& options,
                                          std::string* error) {
  if (options.layout.empty()) {
    *error = path.string() +
             ": raw files do not tell their columns; set input.layout, see --help_config";
    return nullptr;
  }
  ScanFolderQuery query;
  query.candidates = {".", "radar", "velodyne", "training/velodyne", "radar/training/velodyne"};
  if (!options.folder.empty()) query.LookOnlyIn(options.folder);
  query.rate = options.rate;
  std::optional<ScanFolder> folder = OpenScanFolder(path, query, error);
  if (!folder) return nullptr;
  if (LowerCase(options.layout) == kAevaLayout) {
    return std::make_unique<PointFolderSource>(
        *std::move(folder), std::make_unique<AevaFileReader>(), options, "Aeva scans");
  }
  auto reader = std::make_unique<RawFileReader>(LayoutOf(options.layout));
  return std::make_unique<PointFolderSource>(
      *std::move(folder), std::move(reader), options, "raw float32 scans (" + options.layout + ")");
}

std::unique_ptr<ScanSource> OpenHerculesSource(const std::filesystem::path& path,
                                               const InputOptions& options,
                                               std::string* error) {
  ScanFolderQuery query;
  query.candidates = {".", "Radar/Continental", "Continental"};
  // Each sensor comes as an archive of its own, which users unpack into folders of their own.
  query.name_below = "Continental";
  if (!options.folder.empty()) {
    query.candidates = {options.folder};
    query.name_below.clear();
  }
  query.names_are_stamps = true;
  std::optional<ScanFolder> folder = OpenScanFolder(path, query, error);
  if (!folder) return nullptr;
  auto reader = std::make_unique<RawFileReader>(LayoutOf("hercules29"));
  return std::make_unique<PointFolderSource>(
      *std::move(folder), std::move(reader), options, "HeRCULES Continental scans");
}

}  // namespace radive
