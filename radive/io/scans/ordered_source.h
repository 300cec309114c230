// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "radive/io/scans/scan_source.h"
#include "radive/io/scans/stamp_order.h"
#include "radive/util/counted_warnings.h"

namespace radive {

// The scans of `source` in the order of their stamps, with bad stamps replaced and clocks that were
// set undone, see StampOrder. What was done is counted in warnings. Scans in order pass through as
// they are. Reads StampOrder::kReach scans ahead, or, where the source knows the stamps of the
// whole drive, none but those that are in the wrong place: a scan just read is still in the cache.
//
// Of scans with the same stamp, and of those that come more than kReach too late, a source with
// times of recording (a bag) gives the first alone; files are given all the same, so that each has
// its line in the trajectory, and odometry skips them.
class OrderedSource : public ScanSource {
 public:
  explicit OrderedSource(std::unique_ptr<ScanSource> source) : source_(std::move(source)) {
    PassOn(Status::kScan, source_.get());  // what was found on opening
    known_ns_ = source_->Facts().stamps_ns;
    if (static_cast<int>(known_ns_.size()) != source_->NumScans()) known_ns_.clear();
  }

  Status Next(RadarScan* scan) override;
  Status Skip(int count) override;
  std::string Description() const override { return source_->Description(); }
  std::optional<int> NumScans() const override { return source_->NumScans(); }
  SourceFacts Facts() const override { return source_->Facts(); }

 private:
  void LookAhead();
  Status Read(RadarScan* scan);
  Status ReadToPosition(std::size_t position);
  void Warn(const StampOrder::Decision& decision, const RadarScan& scan, bool is_dropped);
  void GiveWarnings();

  const std::unique_ptr<ScanSource> source_;
  StampOrder order_;
  // Of the whole drive; empty: they show as the scans are read.
  std::vector<std::int64_t> known_ns_;
  std::size_t next_known_ = 0;
  // Not given yet, in the order of storage; of the entries the first ones have been read.
  std::deque<RadarScan> scans_;
  std::deque<StampOrder::Entry> entries_;
  std::vector<RadarScan> spare_;  // kept for their memory
  Status status_behind_ = Status::kScan;
  int num_read_ = 0;
  int num_to_pass_over_ = 0;  // scans whose returns nobody will see: the first so many
  CountedWarnings counted_;
};

}  // namespace radive
