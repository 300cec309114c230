// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/point_folder_source.h"

#include <glog/logging.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "radive/io/bytes/record_file.h"

namespace radive {
namespace {

// When none of so many can be read, none will.
constexpr std::size_t kFirstScans = 10;

}  // namespace

PointFolderSource::PointFolderSource(ScanFolder folder,
                                     std::unique_ptr<PointFileReader> reader,
                                     const InputOptions& options,
                                     std::string format)
    : folder_(std::move(folder)),
      reader_(std::move(reader)),
      format_(std::move(format)),
      converter_(options) {
  CHECK(reader_ != nullptr);
  CHECK_EQ(folder_.names.size(), folder_.stamps_ns.size());
  if (!folder_.stamp_doubt.empty()) warnings_.push_back(folder_.stamp_doubt);
  warnings_.insert(warnings_.end(), folder_.warnings.begin(), folder_.warnings.end());
  for (std::size_t i = 0; i < folder_.names.size(); ++i) {
    std::error_code failure;
    const std::uintmax_t size = std::filesystem::file_size(folder_.File(i), failure);
    sizes_.push_back(failure ? 0 : size);
  }
}

ScanSource::Status PointFolderSource::PassOver(RadarScan* scan) {
  if (next_ == folder_.names.size()) return Status::kEnd;
  scan->stamp_ns = folder_.stamps_ns[next_];
  scan->radar = 0;
  scan->has_doppler = false;
  scan->is_planar = false;
  scan->returns.clear();
  scan->place = folder_.File(next_).string();
  ++next_;
  return Status::kScan;
}

// Somebody who cuts files while they are read would get a drive that never was.
bool PointFolderSource::ReadFile(std::size_t index, std::string* reason) {
  const std::string path = folder_.File(index).string();
  if (!ReadWholeFile(path, &content_, reason, &is_unreadable_)) return false;
  if (content_.size() >= sizes_[index]) return true;
  is_unreadable_ = true;
  *reason = path + ": has " + std::to_string(content_.size()) + " bytes, but had " +
            std::to_string(sizes_[index]) + " when the drive was opened";
  return false;
}

bool PointFolderSource::ReadReturns(RadarScan* scan,
                                    std::vector<std::string>* remarks,
                                    std::string* reason) {
  if (!ReadFile(next_ - 1, reason)) return false;
  PointTable table;
  if (reader_->Read(content_, scan->stamp_ns, &table, remarks, reason) &&
      converter_.Convert(table, scan, reason)) {
    return true;
  }
  *reason = scan->place + ": " + *reason;
  return false;
}

bool PointFolderSource::CanReadOneOfTheNext() {
  const std::size_t next = next_;
  bool can_read = false;
  for (std::size_t i = 1; i < kFirstScans && !can_read; ++i) {
    RadarScan scan;
    if (PassOver(&scan) == Status::kEnd) break;
    std::vector<std::string> remarks;
    std::string reason;
    can_read = ReadReturns(&scan, &remarks, &reason);
  }
  next_ = next;
  return can_read;
}

ScanSource::Status PointFolderSource::Next(RadarScan* scan) {
  if (PassOver(scan) == Status::kEnd) return Status::kEnd;
  std::vector<std::string> remarks;
  std::string reason;
  if (!ReadReturns(scan, &remarks, &reason)) {
    if (is_unreadable_) {
      error_ = reason;
      return Status::kError;
    }
    if (!has_looked_ && !CanReadOneOfTheNext()) {
      error_ = reason;
      const std::size_t num_others = std::min(folder_.names.size() - next_, kFirstScans - 1);
      if (num_others > 0) {
        error_ += "; nor can the " + std::to_string(num_others) + " files behind it be read";
      }
      return Status::kError;
    }
    warnings_.push_back(reason + "; taken as an empty scan");
    scan->returns.clear();
  }
  has_looked_ = true;
  for (const std::string& remark : remarks) warnings_.push_back(scan->place + ": " + remark);
  return Status::kScan;
}

std::string PointFolderSource::Description() const {
  return format_ + ", " + std::to_string(folder_.names.size()) + " files in " +
         folder_.path.string() + ", stamps from " + folder_.stamp_origin;
}

std::optional<int> PointFolderSource::NumScans() const {
  return static_cast<int>(folder_.names.size());
}

SourceFacts PointFolderSource::Facts() const {
  SourceFacts facts;
  facts.format = format_;
  facts.place = folder_.path.string();
  facts.stamp_origin = folder_.stamp_origin;
  facts.fields = converter_.Summaries();
  facts.stamps_ns = folder_.stamps_ns;
  if (folder_.stamps_are_positions || folder_.names.size() == 1) {
    facts.why_no_drive = WhyNotConsecutive(folder_.names);
  }
  return facts;
}

}  // namespace radive
