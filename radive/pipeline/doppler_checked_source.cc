// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/doppler_checked_source.h"

#include <utility>

namespace radive {

bool DopplerCheckedSource::CanGoOn() {
  const RadarScan& scan = held_back_.front();
  if (!scan.has_doppler || scan.returns.empty()) return true;
  if (check_.IsDecided(scan.radar) || check_.IsStanding(scan)) return true;
  if (held_back_.size() >= kMostHeldBack * radars_.size() || num_returns_ > kMostReturnsHeldBack) {
    check_.Assume(scan.radar);
  }
  return check_.IsDecided(scan.radar);
}

ScanSource::Status DopplerCheckedSource::Next(RadarScan* scan) {
  while (status_behind_ == Status::kScan && (held_back_.empty() || !CanGoOn())) {
    RadarScan next;
    status_behind_ = PassOn(source_->Next(&next), source_);
    if (status_behind_ != Status::kScan) {
      check_.Finish();
      break;
    }
    radars_.insert(next.radar);
    check_.Add(next);
    num_returns_ += next.returns.size();
    held_back_.push_back(std::move(next));
  }
  if (held_back_.empty()) return status_behind_;
  *scan = std::move(held_back_.front());
  held_back_.pop_front();
  num_returns_ -= scan->returns.size();
  check_.Apply(scan);
  return Status::kScan;
}

}  // namespace radive
