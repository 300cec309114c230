// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/hercules_source.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "radive/io/record_file.h"

namespace radive {
namespace {

constexpr std::size_t kRecordSize = 29;

double Float(const char* bytes) { return static_cast<double>(ReadFloat32(bytes)); }

double SignedByte(const char* byte) {
  std::int8_t value = 0;
  std::memcpy(&value, byte, 1);
  return static_cast<double>(value);
}

}  // namespace

std::unique_ptr<HerculesSource> HerculesSource::Open(const std::filesystem::path& path,
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
  return std::unique_ptr<HerculesSource>(new HerculesSource(*std::move(folder), options));
}

HerculesSource::HerculesSource(ScanFolder folder, const InputOptions& options)
    : RecordFolderSource(std::move(folder),
                         kRecordSize,
                         "HeRCULES Continental scans",
                         "HeRCULES Continental record"),
      doppler_sign_(options.FixedDopplerSign()) {}

void HerculesSource::Decode(std::string_view records, RadarScan* scan) {
  scan->has_doppler = true;
  int num_contradictions = 0;
  for (std::size_t i = 0; i < records.size(); i += kRecordSize) {
    const char* const record = records.data() + i;
    RadarReturn& added = scan->returns.emplace_back();
    added.position = {Float(record), Float(record + 4), Float(record + 8)};
    added.doppler = doppler_sign_ * Float(record + 12);
    added.power = SignedByte(record + 20);
    const double range = Float(record + 16);
    const double difference = std::abs(range - added.position.norm());
    num_contradictions += difference > 0.01 * std::max(1.0, std::abs(range)) ? 1 : 0;
  }
  // Every record states its range twice: a file of another kind shows here.
  if (2 * static_cast<std::size_t>(num_contradictions) > scan->returns.size()) {
    warnings_.push_back(scan->place + ": the stored range is not |x y z| in " +
                        std::to_string(num_contradictions) + " of " +
                        std::to_string(scan->returns.size()) +
                        " records; these may be no HeRCULES Continental records");
  }
}

}  // namespace radive
