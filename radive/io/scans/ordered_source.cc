// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/ordered_source.h"

#include <algorithm>
#include <utility>

#include "radive/io/bytes/stamp_text.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

std::string SignedSeconds(std::int64_t shift_ns) {
  return FormatText("%+.6g s", static_cast<double>(shift_ns) * 1e-9);
}

}  // namespace

ScanSource::Status OrderedSource::Read(RadarScan* scan) {
  const Status status =
      num_read_ < num_to_pass_over_ ? source_->PassOver(scan) : source_->Next(scan);
  status_behind_ = PassOn(status, source_.get());
  if (status == Status::kScan) ++num_read_;
  return status;
}

// The scans up to that of `position` among the entries.
ScanSource::Status OrderedSource::ReadToPosition(std::size_t position) {
  while (scans_.size() <= position) {
    RadarScan scan;
    if (!spare_.empty()) {
      scan = std::move(spare_.back());
      spare_.pop_back();
    }
    const Status status = Read(&scan);
    if (status != Status::kScan) return status;
    scans_.push_back(std::move(scan));
  }
  return Status::kScan;
}

void OrderedSource::LookAhead() {
  while (entries_.size() <= StampOrder::kReach && next_known_ < known_ns_.size()) {
    entries_.push_back({known_ns_[next_known_++], std::nullopt});
  }
  if (!known_ns_.empty() && !entries_.empty()) return;
  while (entries_.size() <= StampOrder::kReach && status_behind_ == Status::kScan) {
    if (ReadToPosition(scans_.size()) != Status::kScan) return;
    entries_.push_back({scans_.back().stamp_ns, source_->record_ns()});
  }
}

void OrderedSource::Warn(const StampOrder::Decision& decision,
                         const RadarScan& scan,
                         bool is_dropped) {
  using Kind = StampOrder::Kind;
  const std::string stamp = scan.place + ": the stamp " + FormatStamp(scan.stamp_ns);
  const std::string fate = is_dropped ? "; it is passed over" : "; it is not used";
  switch (decision.kind) {
    case Kind::kInOrder:
      break;
    case Kind::kLate:
      counted_.Add("scans that were stored late, put in order",
                   stamp + " is earlier than that of a scan before; it is put in order");
      break;
    case Kind::kBadStamp:
      counted_.Add("scans with bad stamps, stamped anew",
                   stamp + " does not fit its neighbours; " + FormatStamp(decision.stamp_ns) +
                       (decision.by_record ? ", by the time of recording, is taken instead"
                                           : ", between its neighbours, is taken instead"));
      break;
    case Kind::kClockSet:
      counted_.Add("times that the clock of the stamps was set",
                   stamp +
                       " is where the clock was set; this stamp and those behind it are moved by " +
                       SignedSeconds(decision.shift_ns) + ", so that they follow those before");
      break;
    case Kind::kRepeated:
      counted_.Add("scans with a stamp that was there before",
                   stamp + " is that of the scan before" + fate);
      break;
    case Kind::kTooLate:
      counted_.Add(
          "scans with a stamp long before the last one's",
          stamp + " is more than " + std::to_string(StampOrder::kReach) + " scans late" + fate);
      break;
  }
}

void OrderedSource::GiveWarnings() {
  for (std::string& warning : counted_.Take()) warnings_.push_back(std::move(warning));
}

ScanSource::Status OrderedSource::Next(RadarScan* scan) {
  for (;;) {
    LookAhead();
    if (entries_.empty()) {
      counted_.Finish();
      GiveWarnings();
      return status_behind_;
    }
    const StampOrder::Decision decision = order_.Next(entries_);
    const auto position = static_cast<std::ptrdiff_t>(decision.position);
    if (scans_.empty() && position == 0) {
      // Nothing is between the source and the caller, who keeps the memory.
      if (Read(scan) != Status::kScan) {
        entries_.clear();
        next_known_ = known_ns_.size();
        continue;
      }
      Warn(decision, *scan, /*is_dropped=*/false);
      GiveWarnings();
      scan->stamp_ns = decision.stamp_ns;
      entries_.pop_front();
      return Status::kScan;
    }
    if (ReadToPosition(decision.position) != Status::kScan) {
      entries_.resize(scans_.size());
      next_known_ = known_ns_.size();
      continue;
    }
    const bool is_unusable =
        decision.kind == StampOrder::Kind::kRepeated || decision.kind == StampOrder::Kind::kTooLate;
    const bool is_dropped = is_unusable && entries_[decision.position].record_ns.has_value();
    RadarScan& next = scans_[decision.position];
    Warn(decision, next, is_dropped);
    GiveWarnings();
    next.stamp_ns = decision.stamp_ns;
    if (!is_dropped) std::swap(*scan, next);
    spare_.push_back(std::move(next));
    scans_.erase(scans_.begin() + position);
    entries_.erase(entries_.begin() + position);
    if (!is_dropped) return Status::kScan;
  }
}

ScanSource::Status OrderedSource::Skip(int count) {
  // Those that may still be given behind the skipped ones are read in full.
  num_to_pass_over_ =
      num_read_ +
      std::max(0, count - static_cast<int>(StampOrder::kReach) - static_cast<int>(scans_.size()));
  return ScanSource::Skip(count);
}

}  // namespace radive
