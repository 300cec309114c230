// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/doppler_checked_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace radive {
namespace {

// Scans in a row without a velocity that make the Doppler be looked at again.
constexpr int kScansWithoutVelocity = 5;
// Fewer scans without numbers are not worth a word.
constexpr int kFewestWithoutNumbers = 5;

bool HasNumbers(const RadarScan& scan) {
  return std::any_of(scan.returns.begin(), scan.returns.end(), [](const RadarReturn& ret) {
    return std::isfinite(ret.doppler);
  });
}

}  // namespace

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
  LookForNumbers(scan);
  check_.Apply(scan);
  return Status::kScan;
}

void DopplerCheckedSource::LookForNumbers(RadarScan* scan) {
  if (scan->returns.empty()) return;
  if (scan->has_doppler && HasNumbers(*scan)) {
    ++num_with_numbers_;
    return;
  }
  scan->has_doppler = false;
  if (num_without_numbers_++ == 0) first_without_numbers_ = scan->place;
}

void DopplerCheckedSource::AddVelocity(const RadarScan& scan, const EgoVelocity& velocity) {
  if (!scan.has_doppler || scan.returns.empty()) return;
  int& num = num_without_velocity_[scan.radar];
  num = velocity.valid ? 0 : num + 1;
  if (num == kScansWithoutVelocity) check_.LookAgain(scan.radar);
}

void DopplerCheckedSource::Conclude() {
  check_.Conclude();
  if (num_with_numbers_ == 0 || num_without_numbers_ < kFewestWithoutNumbers) return;
  remarks_.push_back(
      {true,
       "Doppler is no number in " + std::to_string(num_without_numbers_) + " of " +
           std::to_string(num_with_numbers_ + num_without_numbers_) +
           " scans: these are registered by their points alone" +
           (first_without_numbers_.empty() ? "" : "; the first: " + first_without_numbers_)});
}

std::vector<DopplerRemark> DopplerCheckedSource::TakeRemarks() {
  std::vector<DopplerRemark> remarks = check_.TakeRemarks();
  remarks.insert(remarks.end(), remarks_.begin(), remarks_.end());
  remarks_.clear();
  return remarks;
}

}  // namespace radive
