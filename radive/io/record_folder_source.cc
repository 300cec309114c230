// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/record_folder_source.h"

#include <glog/logging.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "radive/io/record_file.h"

namespace radive {

RecordFolderSource::RecordFolderSource(ScanFolder folder,
                                       std::size_t record_size,
                                       std::string format,
                                       std::string record_name)
    : folder_(std::move(folder)),
      record_size_(record_size),
      format_(std::move(format)),
      record_name_(std::move(record_name)) {
  CHECK_GT(record_size_, 0u);
  CHECK_EQ(folder_.names.size(), folder_.stamps_ns.size());
}

ScanSource::Status RecordFolderSource::Next(RadarScan* scan) {
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
  if (!ReadWholeFile(file, &content_, &reason)) {
    warnings_.push_back(reason + "; taken as an empty scan");
  }
  const std::size_t count = static_cast<std::size_t>(
      CountRecords(file, content_.size(), record_size_, record_name_, &warnings_));
  scan->returns.reserve(count);
  Decode(std::string_view(content_).substr(0, count * record_size_), scan);
  return Status::kScan;
}

ScanSource::Status RecordFolderSource::Skip(int count) {
  const std::size_t left = folder_.names.size() - next_;
  const std::size_t wanted = static_cast<std::size_t>(std::max(count, 0));
  next_ += std::min(left, wanted);
  return wanted <= left ? Status::kScan : Status::kEnd;
}

std::string RecordFolderSource::Description() const {
  return format_ + ", " + std::to_string(folder_.names.size()) + " files in " +
         folder_.path.string() + ", stamps from " + folder_.stamp_origin;
}

std::optional<int> RecordFolderSource::NumScans() const {
  return static_cast<int>(folder_.names.size());
}

}  // namespace radive
