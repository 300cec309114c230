// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "radive/ego_velocity/doppler_check.h"
#include "radive/ego_velocity/ego_velocity.h"
#include "radive/io/scans/scan_source.h"

namespace radive {

// The scans of `source` with the Doppler that DopplerCheck leaves of it. Scans of a radar that
// moves are held back until it is decided what its Doppler is worth, within bounds; scans of one
// that stands go on, as what was said of them by then does not matter.
class DopplerCheckedSource : public ScanSource {
 public:
  static constexpr std::size_t kMostHeldBack = 90;
  static constexpr std::size_t kMostReturnsHeldBack = 2'000'000;

  DopplerCheckedSource(ScanSource* source, DopplerCheck check)
      : source_(source), check_(std::move(check)) {}

  Status Next(RadarScan* scan) override;
  std::string Description() const override { return source_->Description(); }
  std::optional<int> NumScans() const override { return source_->NumScans(); }

  const DopplerCheck& check() const { return check_; }

  // What became of the scan given last. Where the Doppler gives no velocity for some scans, it may
  // have changed, and is looked at again.
  void AddVelocity(const RadarScan& scan, const EgoVelocity& velocity);
  // No more scans will be taken.
  void Conclude();
  std::vector<DopplerRemark> TakeRemarks();

 private:
  // Of the first scan that is held back.
  bool CanGoOn();
  // Scans without a number for the Doppler in a drive that has it: the points alone must do.
  void LookForNumbers(RadarScan* scan);

  ScanSource* const source_;
  DopplerCheck check_;
  std::deque<RadarScan> held_back_;
  std::size_t num_returns_ = 0;                         // of the scans that are held back
  std::set<int> radars_;                                // of the drive so far
  Status status_behind_ = Status::kScan;                // the scans that are held back
  std::map<int, int> num_without_velocity_;             // radar -> scans in a row
  int num_with_numbers_ = 0, num_without_numbers_ = 0;  // scans
  std::string first_without_numbers_;                   // its place
  std::vector<DopplerRemark> remarks_;
};

}  // namespace radive
