// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/csv_drive_source.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/io/points/csv_points.h"
#include "radive/io/scans/stamp_sequence.h"
#include "radive/util/natural_order.h"

namespace radive {
namespace {

// Times closer together than this are of the points of a scan [ns].
constexpr std::int64_t kShortestInterval = 1'000'000;

// Puts the scans into the order of their stamps.
void SortByStamp(std::vector<std::int64_t>* stamps_ns, std::vector<CsvScan>* scans) {
  std::vector<std::pair<std::int64_t, CsvScan>> both;
  for (std::size_t i = 0; i < scans->size(); ++i) {
    both.emplace_back((*stamps_ns)[i], std::move((*scans)[i]));
  }
  std::stable_sort(both.begin(), both.end(), [](const auto& one, const auto& other) {
    return one.first < other.first;
  });
  for (std::size_t i = 0; i < both.size(); ++i) {
    (*stamps_ns)[i] = both[i].first;
    (*scans)[i] = std::move(both[i].second);
  }
}

}  // namespace

std::unique_ptr<CsvDriveSource> CsvDriveSource::Open(const std::filesystem::path& file,
                                                     const InputOptions& options) {
  std::unique_ptr<CsvDriveSource> source(new CsvDriveSource(file, options));
  std::string ignored;
  if (!ReadWholeFile(file, &source->text_, &ignored)) return nullptr;
  std::optional<CsvDrive> drive = SplitCsvDrive(source->text_);
  if (!drive) return nullptr;
  source->drive_ = *std::move(drive);
  std::vector<CsvScan>& scans = source->drive_.scans;
  if (!source->drive_.has_times) {
    std::stable_sort(scans.begin(), scans.end(), [](const CsvScan& one, const CsvScan& other) {
      return NaturalLess(std::string(one.key), std::string(other.key));
    });
    source->StampFrames(options.rate);
    return source;
  }
  std::vector<std::string_view> texts;
  for (const CsvScan& scan : scans) texts.push_back(scan.key);
  std::size_t bad = 0;
  std::optional<StampSequence> sequence = ReadStampSequence(texts, options.rate, &bad);
  if (!sequence) return nullptr;
  source->stamps_ns_ = std::move(sequence->stamps_ns);
  SortByStamp(&source->stamps_ns_, &scans);
  const std::int64_t length_ns = source->stamps_ns_.back() - source->stamps_ns_.front();
  if (length_ns / static_cast<std::int64_t>(scans.size() - 1) < kShortestInterval) return nullptr;
  source->stamp_origin_ = "column " + source->drive_.column + " (" + sequence->unit + ")";
  if (!sequence->doubt.empty()) {
    source->warnings_.push_back(file.string() + ": " + sequence->doubt);
  }
  return source;
}

// By a column of times beside that of frames; else by the numbers of the frames and the rate.
void CsvDriveSource::StampFrames(double rate) {
  std::vector<std::string_view> times, numbers;
  for (const CsvScan& scan : drive_.scans) {
    times.push_back(scan.time);
    numbers.push_back(scan.key);
  }
  std::size_t bad = 0;
  std::optional<StampSequence> sequence = ReadStampSequence(times, rate, &bad);
  if (sequence && !sequence->rate_is_used && sequence->doubt.empty()) {
    stamps_ns_ = std::move(sequence->stamps_ns);
    stamp_origin_ = "the column of times (" + sequence->unit + ")";
    return;
  }
  // The time of numbers that are left out passes.
  sequence = ReadStampSequence(numbers, rate, &bad);
  if (sequence && sequence->rate_is_used) {
    stamps_ns_ = std::move(sequence->stamps_ns);
  } else {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      stamps_ns_.push_back(StampAt(static_cast<double>(i), rate));
    }
  }
  stamp_origin_ = "input.rate";
  if (!(rate > 0.0)) {
    warnings_.push_back(file_.string() + ": the scans have no stamps; " + AssumedRateText());
  }
}

ScanSource::Status CsvDriveSource::PassOver(RadarScan* scan) {
  if (next_ == drive_.scans.size()) return Status::kEnd;
  scan->stamp_ns = stamps_ns_[next_];
  scan->radar = 0;
  scan->has_doppler = false;
  scan->is_planar = false;
  scan->returns.clear();
  scan->place = file_.string() + ": " + drive_.column + " " + std::string(drive_.scans[next_].key);
  ++next_;
  return Status::kScan;
}

ScanSource::Status CsvDriveSource::Next(RadarScan* scan) {
  if (PassOver(scan) == Status::kEnd) return Status::kEnd;
  content_ = drive_.head;
  for (const std::string_view lines : drive_.scans[next_ - 1].lines) content_ += lines;
  PointTable table;
  std::vector<std::string> remarks;
  std::string reason;
  if (!ParseCsvPoints(content_, &table, &remarks, &reason) ||
      !converter_.Convert(table, scan, &reason)) {
    // All scans have the same columns.
    error_ = scan->place + ": " + reason;
    return Status::kError;
  }
  for (const std::string& remark : remarks) warnings_.push_back(scan->place + ": " + remark);
  return Status::kScan;
}

std::string CsvDriveSource::Description() const {
  return "CSV table of " + std::to_string(drive_.scans.size()) + " scans by its column " +
         Quoted(drive_.column) + ", " + file_.string() + ", stamps from " + stamp_origin_;
}

std::optional<int> CsvDriveSource::NumScans() const {
  return static_cast<int>(drive_.scans.size());
}

SourceFacts CsvDriveSource::Facts() const {
  SourceFacts facts;
  facts.format = "CSV table of " + std::to_string(drive_.scans.size()) + " scans by its column " +
                 Quoted(drive_.column);
  facts.place = file_.string();
  facts.stamp_origin = stamp_origin_;
  facts.fields = converter_.Summaries();
  facts.stamps_ns = stamps_ns_;
  return facts;
}

}  // namespace radive
