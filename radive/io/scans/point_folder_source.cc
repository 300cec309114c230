// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/point_folder_source.h"

#include <glog/logging.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "radive/io/bytes/record_file.h"

namespace radive {

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
}

ScanSource::Status PointFolderSource::Next(RadarScan* scan) {
  if (next_ == folder_.names.size()) return Status::kEnd;
  const std::filesystem::path file = folder_.File(next_);
  scan->stamp_ns = folder_.stamps_ns[next_];
  scan->radar = 0;
  scan->has_doppler = false;
  scan->is_planar = false;
  scan->returns.clear();
  scan->place = file.string();
  ++next_;

  std::string reason;
  bool is_unreadable = false;
  if (!ReadWholeFile(file, &content_, &reason, &is_unreadable)) {
    if (is_unreadable) {
      error_ = reason;
      return Status::kError;
    }
    warnings_.push_back(reason + "; taken as an empty scan");
    return Status::kScan;
  }
  PointTable table;
  std::vector<std::string> remarks;
  if (!reader_->Read(content_, scan->stamp_ns, &table, &remarks, &reason) ||
      !converter_.Convert(table, scan, &reason)) {
    warnings_.push_back(scan->place + ": " + reason + "; taken as an empty scan");
  }
  for (const std::string& remark : remarks) warnings_.push_back(scan->place + ": " + remark);
  return Status::kScan;
}

ScanSource::Status PointFolderSource::Skip(int count) {
  const std::size_t left = folder_.names.size() - next_;
  const std::size_t wanted = static_cast<std::size_t>(std::max(count, 0));
  next_ += std::min(left, wanted);
  return wanted <= left ? Status::kScan : Status::kEnd;
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
