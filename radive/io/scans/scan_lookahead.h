// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>

#include "radive/io/scans/scan_source.h"

namespace radive {

// Lets the first scans of a source be looked at before they are delivered.
class ScanLookahead {
 public:
  explicit ScanLookahead(ScanSource* source) : source_(source) {}

  // Holds the next scans back, up to `count` of them.
  void Read(std::size_t count) {
    while (held_back_.size() < count && status_behind_ == ScanSource::Status::kScan) {
      RadarScan scan;
      status_behind_ = source_->Next(&scan);
      if (status_behind_ == ScanSource::Status::kScan) held_back_.push_back(std::move(scan));
    }
  }
  const std::deque<RadarScan>& held_back() const { return held_back_; }

  // As of a ScanSource: the scans that were held back, then those behind them.
  ScanSource::Status Next(RadarScan* scan) {
    if (!held_back_.empty()) {
      *scan = std::move(held_back_.front());
      held_back_.pop_front();
      return ScanSource::Status::kScan;
    }
    return status_behind_ == ScanSource::Status::kScan ? source_->Next(scan) : status_behind_;
  }
  ScanSource::Status Skip(int count) {
    const int held_back = std::min(count, static_cast<int>(held_back_.size()));
    held_back_.erase(held_back_.begin(), held_back_.begin() + held_back);
    if (count == held_back) return ScanSource::Status::kScan;
    return status_behind_ == ScanSource::Status::kScan ? source_->Skip(count - held_back)
                                                       : status_behind_;
  }

 private:
  ScanSource* const source_;
  std::deque<RadarScan> held_back_;
  ScanSource::Status status_behind_ = ScanSource::Status::kScan;  // the scans that are held back
};

}  // namespace radive
