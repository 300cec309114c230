// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/datasets/radarscenes_source.h"

#include <glog/logging.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "radive/io/bytes/record_file.h"
#include "radive/io/scans/scan_folder.h"
#include "radive/io/scans/scan_stamps.h"
#include "radive/util/system_message.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kRowSize = 20;

// "radar1, radar3"
std::string FoldersOf(const std::vector<int>& radars) {
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
      *error = path.string() + ": cannot be opened (" + SystemMessage(failure) +
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

std::vector<int> RadarsOfRadarScenes(const fs::path& folder) {
  std::vector<int> radars;
  for (int k = 1; k <= 99; ++k) {
    std::error_code ignored;
    if (fs::exists(folder / ("radar" + std::to_string(k) + "_scans.csv"), ignored)) {
      radars.push_back(k);
    }
  }
  return radars;
}

std::unique_ptr<ScanSource> RadarScenesSource::Open(const fs::path& path,
                                                    const InputOptions& options,
                                                    std::string* error) {
  const fs::path folder = options.folder.empty() ? path : path / options.folder;
  if (!CheckIsFolder(folder, error)) return nullptr;
  const std::optional<std::int64_t> radar = ParseInteger(options.radar);
  CHECK(radar) << "input options were not checked: radar " << options.radar;
  std::unique_ptr<RadarScenesSource> source(new RadarScenesSource(options));
  source->radar_ = static_cast<int>(*radar);
  const std::string name = "radar" + std::to_string(source->radar_);
  source->table_path_ = folder / (name + "_scans.csv");
  std::error_code ignored;
  if (!fs::exists(source->table_path_, ignored)) {
    *error =
        source->table_path_.string() + ": does not exist, expected the scans of " + name +
        " (input.radar); radars found in the folder: " + FoldersOf(RadarsOfRadarScenes(folder));
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
  return ReadWholeFile(table_path_, &text, error) &&
         ParseRadarScenesTable(text, table_path_.string(), &entries_, error);
}

// Each row of the file belongs to one scan, in their order; else lines or rows were lost.
bool RadarScenesSource::CheckRows(std::uint64_t num_rows, std::string* error) {
  int num_apart = 0;
  std::string first_apart;
  std::uint64_t end = 0;
  const auto expect = [&](std::uint64_t row, int line) {
    if (row != end && num_apart++ == 0) {
      first_apart = ":" + std::to_string(line) + ": the rows before it end with " +
                    std::to_string(end) + ", not " + std::to_string(row);
    }
  };
  for (const RadarScenesScan& entry : entries_) {
    expect(entry.first_point, entry.line);
    end = entry.first_point + entry.num_points;
    if (entry.num_points <= num_rows && entry.first_point <= num_rows - entry.num_points) continue;
    *error = table_path_.string() + ":" + std::to_string(entry.line) + ": first_point " +
             std::to_string(entry.first_point) + " and num_points " +
             std::to_string(entry.num_points) + " reach beyond the " + std::to_string(num_rows) +
             " rows of " + points_->path().string();
    return false;
  }
  expect(num_rows, entries_.back().line + 1);
  if (num_apart > 0) {
    warnings_.push_back(table_path_.string() + first_apart + " (" + std::to_string(num_apart) +
                        " such places): the scans do not share out the " +
                        std::to_string(num_rows) + " rows of " + points_->path().string() +
                        ", so lines or rows are lost or damaged");
  }
  return true;
}

ScanSource::Status RadarScenesSource::PassOver(RadarScan* scan) {
  if (next_ == entries_.size()) return Status::kEnd;
  const RadarScenesScan& entry = entries_[next_++];
  scan->stamp_ns = entry.stamp_ns;
  scan->radar = radar_;
  scan->has_doppler = true;
  scan->is_planar = true;
  scan->returns.clear();
  scan->place = table_path_.string() + ":" + std::to_string(entry.line);
  return Status::kScan;
}

ScanSource::Status RadarScenesSource::Next(RadarScan* scan) {
  if (PassOver(scan) == Status::kEnd) return Status::kEnd;
  const RadarScenesScan& entry = entries_[next_ - 1];
  if (entry.num_points == 0) return Status::kScan;
  if (!points_->Read(entry.first_point, entry.num_points, &rows_.owned)) {
    error_ = scan->place + ": the rows of " + points_->path().string() + " can no longer be read";
    return Status::kError;
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
  for (const RadarScenesScan& entry : entries_) facts.stamps_ns.push_back(entry.stamp_ns);
  return facts;
}

std::optional<int> RadarScenesSource::NumScans() const { return static_cast<int>(entries_.size()); }

}  // namespace radive
