// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/radarscenes_source.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

#include "radive/io/merged_source.h"
#include "radive/io/record_file.h"
#include "radive/io/scan_folder.h"
#include "radive/io/scan_stamps.h"
#include "radive/io/stamp_text.h"
#include "radive/io/text_lines.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRowSize = 20;

enum Column { kTime, kFirstPoint, kNumPoints, kNumColumns };
constexpr std::array<std::string_view, kNumColumns> kColumnNames = {
    "timestamp_rad", "first_point", "num_points"};

// The cells of a line at the given positions; false when the line ends before one of them.
bool TakeCells(std::string_view line,
               const std::array<int, kNumColumns>& positions,
               std::array<std::string_view, kNumColumns>* cells) {
  int num_found = 0;
  for (int position = 0; num_found < kNumColumns; ++position) {
    const std::size_t comma = line.find(',');
    for (std::size_t c = 0; c < kNumColumns; ++c) {
      if (positions[c] != position) continue;
      (*cells)[c] = TrimBlanks(line.substr(0, comma));
      ++num_found;
    }
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  return num_found == kNumColumns;
}

// Position of each column in the line of names; false when one is absent or there twice.
bool FindColumns(std::string_view header, std::array<int, kNumColumns>* positions) {
  positions->fill(-1);
  for (int position = 0;; ++position) {
    const std::size_t comma = header.find(',');
    const std::string_view name = TrimBlanks(header.substr(0, comma));
    for (std::size_t c = 0; c < kNumColumns; ++c) {
      if (name != kColumnNames[c]) continue;
      if ((*positions)[c] >= 0) return false;
      (*positions)[c] = position;
    }
    if (comma == std::string_view::npos) break;
    header.remove_prefix(comma + 1);
  }
  return *std::min_element(positions->begin(), positions->end()) >= 0;
}

// The radars that have a table in `folder`, by number.
std::vector<int> RadarsIn(const fs::path& folder) {
  std::vector<int> radars;
  for (int k = 1; k <= 99; ++k) {
    std::error_code ignored;
    if (fs::exists(folder / ("radar" + std::to_string(k) + "_scans.csv"), ignored)) {
      radars.push_back(k);
    }
  }
  return radars;
}

// "radar1, radar3"
std::string NamesOf(const std::vector<int>& radars) {
  std::string names;
  for (const int k : radars) names += (names.empty() ? "radar" : ", radar") + std::to_string(k);
  return names.empty() ? "none" : names;
}

}  // namespace

// The file of points, open, read by ranges of rows.
class RadarScenesSource::PointFile {
 public:
  // Null when the file cannot be opened, with the reason in `error`.
  static std::unique_ptr<PointFile> Open(const fs::path& path, std::string* error) {
    std::error_code failure;
    const std::uint64_t size = fs::file_size(path, failure);
    std::unique_ptr<PointFile> points(new PointFile(path, size));
    if (!failure && points->file_ == nullptr) failure = {errno, std::generic_category()};
    if (failure) {
      *error = path.string() + ": cannot be opened (" + failure.message() +
               "), expected the points of the radar, rows of 5 float32";
      return nullptr;
    }
    if (IsLfsPointer(path, error)) return nullptr;
    return points;
  }

  ~PointFile() {
    if (file_ != nullptr) std::fclose(file_);
  }

  // Rows of the file; warns when its size is no multiple of a row.
  std::uint64_t CountRows(std::vector<std::string>* warnings) const {
    std::vector<std::string> remarks;
    const std::uint64_t count = CountRecords(size_, kRowSize, "row of 5 float32", &remarks);
    for (const std::string& remark : remarks) warnings->push_back(path_.string() + ": " + remark);
    return count;
  }

  // Reads the bytes of rows [first, first + count), which the file must have, into `rows`. False
  // when the file has changed since it was opened.
  bool Read(std::uint64_t first, std::uint64_t count, std::vector<char>* rows) {
    rows->resize(static_cast<std::size_t>(count * kRowSize));
    return fseeko(file_, static_cast<off_t>(first * kRowSize), SEEK_SET) == 0 &&
           std::fread(rows->data(), 1, rows->size(), file_) == rows->size();
  }

  const fs::path& path() const { return path_; }

 private:
  PointFile(const fs::path& path, std::uint64_t size)
      : path_(path), size_(size), file_(std::fopen(path.c_str(), "rb")) {}
  PointFile(const PointFile&) = delete;
  PointFile& operator=(const PointFile&) = delete;

  const fs::path path_;
  const std::uint64_t size_;  // [bytes]
  std::FILE* const file_;
};

RadarScenesSource::RadarScenesSource(const InputOptions& options) : converter_(options) {
  for (const char* name : {"range", "azimuth", "vr", "rcs", "label"}) {
    rows_.AddField(name, NumericType::kFloat32);
  }
}
RadarScenesSource::~RadarScenesSource() = default;

std::unique_ptr<ScanSource> RadarScenesSource::Open(const fs::path& path,
                                                    const InputOptions& options,
                                                    std::string* error) {
  const fs::path folder = options.folder.empty() ? path : path / options.folder;
  if (!CheckIsFolder(folder, error)) return nullptr;
  if (options.radar != "all") {
    const std::optional<std::int64_t> radar = ParseInteger(options.radar);
    CHECK(radar) << "input options were not checked: radar " << options.radar;
    return OpenRadar(folder, static_cast<int>(*radar), options, error);
  }
  std::vector<std::unique_ptr<ScanSource>> sources;
  for (const int radar : RadarsIn(folder)) {
    sources.push_back(OpenRadar(folder, radar, options, error));
    if (sources.back() == nullptr) return nullptr;
  }
  if (!sources.empty()) return std::make_unique<MergedSource>(std::move(sources));
  *error = folder.string() + ": expected radar1_scans.csv, radar2_scans.csv, ..., found none";
  return nullptr;
}

std::unique_ptr<RadarScenesSource> RadarScenesSource::OpenRadar(const fs::path& folder,
                                                                int radar,
                                                                const InputOptions& options,
                                                                std::string* error) {
  std::unique_ptr<RadarScenesSource> source(new RadarScenesSource(options));
  source->radar_ = radar;
  const std::string name = "radar" + std::to_string(source->radar_);
  source->table_path_ = folder / (name + "_scans.csv");
  std::error_code ignored;
  if (!fs::exists(source->table_path_, ignored)) {
    *error = source->table_path_.string() + ": does not exist, expected the scans of " + name +
             " (input.radar); radars found in the folder: " + NamesOf(RadarsIn(folder));
    return nullptr;
  }
  if (!source->ReadTable(error)) return nullptr;
  source->points_ = PointFile::Open(folder / (name + "_points.bin"), error);
  if (source->points_ == nullptr) return nullptr;
  const std::uint64_t num_rows = source->points_->CountRows(&source->warnings_);
  if (!source->CheckRows(num_rows, error)) return nullptr;
  return source;
}

bool RadarScenesSource::ReadTable(std::string* error) {
  std::string text;
  if (!ReadWholeFile(table_path_, &text, error)) return false;
  TextLines lines(text);
  std::string_view line;
  std::array<int, kNumColumns> positions;
  if (!lines.Next(&line) || !FindColumns(line, &positions)) {
    *error = table_path_.string() + ":1: expected the names of the columns, among them once each " +
             "timestamp_rad, first_point and num_points, found " + Quoted(line);
    return false;
  }
  while (lines.Next(&line)) {
    if (TrimBlanks(line).empty()) continue;
    std::array<std::string_view, kNumColumns> cells;
    const bool complete = TakeCells(line, positions, &cells);
    const auto stamp = complete ? ParseStamp(cells[kTime]) : std::nullopt;
    const auto first = complete ? ParseInteger(cells[kFirstPoint]) : std::nullopt;
    const auto count = complete ? ParseInteger(cells[kNumPoints]) : std::nullopt;
    if (!stamp || !first || !count || *first < 0 || *count < 0) {
      *error = table_path_.string() + ":" + std::to_string(lines.number()) +
               ": expected seconds in timestamp_rad and whole numbers from 0 in first_point and " +
               "num_points, found " + Quoted(line);
      return false;
    }
    entries_.push_back({*stamp,
                        static_cast<std::uint64_t>(*first),
                        static_cast<std::uint64_t>(*count),
                        lines.number()});
  }
  if (!entries_.empty()) return true;
  *error = table_path_.string() +
           ": expected a line a scan after the names of the columns, found "
           "none";
  return false;
}

bool RadarScenesSource::CheckRows(std::uint64_t num_rows, std::string* error) const {
  for (const Entry& entry : entries_) {
    if (entry.num_points <= num_rows && entry.first_point <= num_rows - entry.num_points) continue;
    *error = table_path_.string() + ":" + std::to_string(entry.line) + ": first_point " +
             std::to_string(entry.first_point) + " and num_points " +
             std::to_string(entry.num_points) + " reach beyond the " + std::to_string(num_rows) +
             " rows of " + points_->path().string();
    return false;
  }
  return true;
}

ScanSource::Status RadarScenesSource::Next(RadarScan* scan) {
  if (next_ == entries_.size()) return Status::kEnd;
  const Entry& entry = entries_[next_++];
  scan->stamp_ns = entry.stamp_ns;
  scan->radar = radar_;
  scan->has_doppler = true;
  scan->is_planar = true;
  scan->returns.clear();
  scan->place = table_path_.string() + ":" + std::to_string(entry.line);

  if (entry.num_points == 0) return Status::kScan;
  if (!points_->Read(entry.first_point, entry.num_points, &rows_.owned)) {
    warnings_.push_back(scan->place + ": the rows of " + points_->path().string() +
                        " can no longer be read; taken as an empty scan");
    return Status::kScan;
  }
  rows_.data = rows_.owned.data();
  rows_.num_points = static_cast<std::size_t>(entry.num_points);
  std::string reason;
  if (!converter_.Convert(rows_, scan, &reason)) {
    error_ = points_->path().string() + ": " + reason;
    return Status::kError;
  }
  return Status::kScan;
}

ScanSource::Status RadarScenesSource::Skip(int count) {
  const std::size_t left = entries_.size() - next_;
  const std::size_t wanted = static_cast<std::size_t>(std::max(count, 0));
  next_ += std::min(left, wanted);
  return wanted <= left ? Status::kScan : Status::kEnd;
}

std::string RadarScenesSource::Description() const {
  return "RadarScenes radar " + std::to_string(radar_) + ", " + std::to_string(entries_.size()) +
         " scans in " + table_path_.string();
}

SourceFacts RadarScenesSource::Facts() const {
  SourceFacts facts;
  facts.format = "RadarScenes radar " + std::to_string(radar_);
  facts.place = table_path_.string();
  facts.stamp_origin = "timestamp_rad";
  facts.fields = converter_.Summaries();
  for (const Entry& entry : entries_) facts.stamps_ns.push_back(entry.stamp_ns);
  return facts;
}

std::optional<int> RadarScenesSource::NumScans() const { return static_cast<int>(entries_.size()); }

}  // namespace radive
