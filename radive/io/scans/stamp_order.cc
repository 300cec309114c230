// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/stamp_order.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "radive/io/scans/stamp_sequence.h"

namespace radive {
namespace {

using Entries = std::deque<StampOrder::Entry>;

// An interval up to this is ordinary: so many usual ones, or so long [s].
constexpr double kOrdinaryIntervals = 10.0;
constexpr double kOrdinaryTime = 1.0;
// By how much stamps and times of recording may disagree [s], [-]: buffers and disks stall.
constexpr double kRecordTolerance = 1.0;
constexpr double kRecordShare = 0.1;
// Scans are not stored much faster than they are made: less of the usual interval is a clock that
// was set back a little.
constexpr double kLeastShare = 0.8;
// Share of the usual interval around a stamp without another: a scan is missing there.
constexpr double kHole = 0.4;
constexpr std::size_t kRecent = 100;

// Periods of clocks that start again [s].
constexpr std::array<double, 6> kPeriods = {
    4.294967296, 4294.967296, 4294967.296, 3600.0, 86400.0, 604800.0};

// Without signs in between: hostile stamps lie further apart than there are numbers.
std::int64_t Sum(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b));
}

// a - b [s]
double Seconds(std::int64_t a, std::int64_t b) {
  return (static_cast<double>(a / 1'000'000'000) - static_cast<double>(b / 1'000'000'000)) +
         static_cast<double>(a % 1'000'000'000 - b % 1'000'000'000) * 1e-9;
}

std::int64_t Nanoseconds(double seconds) { return std::llround(seconds * 1e9); }

// Median interval of the entries by their stamps, or by their times of recording [s]; 0: none.
double MedianInterval(const Entries& entries, bool by_record) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < entries.size(); ++i) {
    double interval = Seconds(entries[i].stamp_ns, entries[i - 1].stamp_ns);
    if (by_record) {
      if (!entries[i].record_ns || !entries[i - 1].record_ns) continue;
      interval = Seconds(*entries[i].record_ns, *entries[i - 1].record_ns);
    }
    if (interval > 1e-4 && interval < 10.0) intervals.push_back(interval);
  }
  if (intervals.empty()) return 0.0;
  std::sort(intervals.begin(), intervals.end());
  return intervals[intervals.size() / 2];
}

}  // namespace

std::int64_t StampOrder::Shifted(const Entry& entry) const {
  return Sum(entry.stamp_ns, shift_ns_);
}

double StampOrder::SinceLast(const Entry& entry) const { return Seconds(Shifted(entry), last_ns_); }

std::optional<double> StampOrder::RecordedSinceLast(const Entry& entry) const {
  if (!entry.record_ns || !last_record_ns_) return std::nullopt;
  return Seconds(*entry.record_ns, *last_record_ns_);
}

bool StampOrder::IsNear(double since_last) const {
  return since_last > 0.0 &&
         since_last <= std::max(kOrdinaryIntervals * usual_interval_, kOrdinaryTime);
}

// Whether the stamp of a later entry is what the clock of the last scan would say there.
bool StampOrder::ContinuesClock(const Entries& entries, std::size_t position) const {
  const double since_last = SinceLast(entries[position]);
  const double num_intervals = static_cast<double>(position) + 1.0;
  if (since_last < kLeastShare * num_intervals * usual_interval_) return false;
  const std::optional<double> recorded = RecordedSinceLast(entries[position]);
  if (recorded) {
    return std::abs(since_last - *recorded) <=
           kRecordTolerance + kRecordShare * std::abs(*recorded) + num_intervals * usual_interval_;
  }
  return IsNear(since_last / num_intervals) || IsNear(since_last);
}

// The first of the next entries with which the clock goes on as before. Behind a gap all stamps are
// later than the first.
std::optional<std::size_t> StampOrder::Return(const Entries& entries) const {
  const double first = SinceLast(entries[0]);
  for (std::size_t i = 1; i < std::min(entries.size(), kReach + 1); ++i) {
    if (first > 0.0 && SinceLast(entries[i]) >= first) continue;
    if (ContinuesClock(entries, i)) return i;
  }
  return std::nullopt;
}

// Whether the scans given lately leave room for one at this stamp.
bool StampOrder::IsInHole(std::int64_t stamp_ns) const {
  if (recent_ns_.empty() || Seconds(stamp_ns, recent_ns_.front()) < 0.0) return false;
  return std::all_of(recent_ns_.begin(), recent_ns_.end(), [&](std::int64_t other) {
    return std::abs(Seconds(stamp_ns, other)) > kHole * usual_interval_;
  });
}

// Finds the first entry that most others agree with: those before it are bad.
void StampOrder::Start(const Entries& entries) {
  has_started_ = true;
  usual_interval_ = MedianInterval(entries, /*by_record=*/false);
  if (usual_interval_ == 0.0) usual_interval_ = MedianInterval(entries, /*by_record=*/true);
  if (usual_interval_ == 0.0) usual_interval_ = 1.0 / kAssumedRate;
  std::size_t best = 0;
  int most = std::numeric_limits<int>::min();
  for (std::size_t i = 0; i < entries.size(); ++i) {
    int num_agreeing = 0;
    for (std::size_t j = 0; j < entries.size(); ++j) {
      const double apart = Seconds(entries[j].stamp_ns, entries[i].stamp_ns);
      const double steps = static_cast<double>(j) - static_cast<double>(i);
      const bool is_recorded = entries[i].record_ns && entries[j].record_ns;
      const double expected = is_recorded ? Seconds(*entries[j].record_ns, *entries[i].record_ns)
                                          : steps * usual_interval_;
      const double tolerance = is_recorded
                                   ? kRecordTolerance
                                   : std::max(kOrdinaryIntervals * usual_interval_, kOrdinaryTime);
      if (i == j) continue;
      const bool is_gap = !is_recorded && j > i && apart > 0.0 && apart <= kLongestGap;
      if (apart == 0.0) {
        num_agreeing -= 2;
      } else if (is_gap || std::abs(apart - expected) <= tolerance) {
        ++num_agreeing;
      }
    }
    if (num_agreeing > most) {
      most = num_agreeing;
      best = i;
    }
  }
  // As if a scan had been in front of the first.
  std::int64_t first_ns =
      Sum(entries[best].stamp_ns, -Nanoseconds(static_cast<double>(best) * usual_interval_));
  for (const Entry& entry : entries) {
    const double before = Seconds(first_ns, entry.stamp_ns);
    if (before > 0.0 && before <= static_cast<double>(kReach) * usual_interval_) {
      first_ns = entry.stamp_ns;
    }
  }
  last_ns_ = Sum(first_ns, -Nanoseconds(usual_interval_));
  if (best > 0 && entries[0].record_ns && entries[best].record_ns) {
    const double recorded = Seconds(*entries[best].record_ns, *entries[0].record_ns);
    if (recorded > 0.0) {
      last_ns_ = Sum(entries[best].stamp_ns, -Nanoseconds(recorded + usual_interval_));
    }
    last_record_ns_ = Sum(*entries[0].record_ns, -Nanoseconds(usual_interval_));
  }
}

// The earliest of the next scans that are later than the last one.
StampOrder::Decision StampOrder::TakeInOrder(const Entries& entries) {
  Decision decision;
  decision.stamp_ns = Shifted(entries[0]);
  int num_earlier = 0;
  for (std::size_t i = 1; i < std::min(entries.size(), kReach + 1); ++i) {
    const std::int64_t stamp_ns = Shifted(entries[i]);
    if (stamp_ns <= last_ns_ || stamp_ns >= Shifted(entries[0])) continue;
    ++num_earlier;
    if (stamp_ns >= decision.stamp_ns) continue;
    decision.position = i;
    decision.kind = Kind::kLate;
    decision.stamp_ns = stamp_ns;
  }
  // One that several others overtake is not several that are late, when it leaves a hole.
  const double interval = Seconds(decision.stamp_ns, last_ns_);
  if (num_earlier >= 2 && interval > 1.5 * usual_interval_ && IsNear(interval)) {
    return Restamp(entries, decision.position);
  }
  return decision;
}

StampOrder::Decision StampOrder::Restamp(const Entries& entries,
                                         std::optional<std::size_t> next_good) {
  Decision decision;
  decision.kind = Kind::kBadStamp;
  const std::optional<double> recorded = RecordedSinceLast(entries[0]);
  double since_last = usual_interval_;
  double latest = INFINITY;
  if (next_good) {
    latest = SinceLast(entries[*next_good]);
    since_last = latest / (static_cast<double>(*next_good) + 1.0);
  }
  if (recorded && *recorded > 0.1 * usual_interval_ && *recorded < latest) {
    since_last = *recorded;
    decision.by_record = true;
  }
  decision.stamp_ns = Sum(last_ns_, std::max<std::int64_t>(1, Nanoseconds(since_last)));
  return decision;
}

StampOrder::Decision StampOrder::Resynchronise(const Entry& entry) {
  const double step = SinceLast(entry);
  const std::optional<double> recorded = RecordedSinceLast(entry);
  double since_last = usual_interval_;
  const auto period = std::find_if(kPeriods.begin(), kPeriods.end(), [&](double seconds) {
    return step + seconds > 0.0 && step + seconds <= 3.0 * usual_interval_;
  });
  if (recorded && *recorded > 0.1 * usual_interval_ && *recorded <= kLongestGap) {
    since_last = *recorded;
  } else if (period != kPeriods.end()) {
    since_last = step + *period;
  }
  Decision decision;
  decision.kind = Kind::kClockSet;
  decision.stamp_ns = Sum(last_ns_, std::max<std::int64_t>(1, Nanoseconds(since_last)));
  shift_ns_ = Sum(shift_ns_, Sum(decision.stamp_ns, -Shifted(entry)));
  return decision;
}

StampOrder::Decision StampOrder::Take(const Entries& entries, Decision decision) {
  decision.shift_ns = shift_ns_;
  if (decision.kind == Kind::kRepeated || decision.kind == Kind::kTooLate) return decision;
  const double interval = Seconds(decision.stamp_ns, last_ns_);
  if (IsNear(interval) && !recent_ns_.empty()) {
    usual_interval_ += 0.1 * (std::min(interval, 2.0 * usual_interval_) - usual_interval_);
  }
  last_ns_ = decision.stamp_ns;
  last_record_ns_ = entries[decision.position].record_ns;
  recent_ns_.push_back(last_ns_);
  if (recent_ns_.size() > kRecent) recent_ns_.pop_front();
  return decision;
}

StampOrder::Decision StampOrder::Next(const Entries& entries) {
  CHECK(!entries.empty());
  if (!has_started_) Start(entries);
  const Entry& entry = entries.front();
  const double since_last = SinceLast(entry);
  if (IsNear(since_last)) return Take(entries, TakeInOrder(entries));

  const std::optional<std::size_t> next_good = Return(entries);
  const std::optional<double> recorded = RecordedSinceLast(entry);
  Decision as_stored;
  as_stored.stamp_ns = Shifted(entry);
  if (since_last == 0.0 && !recent_ns_.empty()) {
    const bool leaves_hole =
        next_good &&
        SinceLast(entries[*next_good]) > (static_cast<double>(*next_good) + 0.5) * usual_interval_;
    const bool is_another_scan = recorded ? *recorded > 0.5 * usual_interval_ : leaves_hole;
    if (is_another_scan) return Take(entries, Restamp(entries, next_good));
    as_stored.kind = Kind::kRepeated;
    return Take(entries, as_stored);
  }
  const bool is_at_end = entries.size() == 1;
  if (since_last < 0.0 && (next_good || is_at_end) && IsInHole(as_stored.stamp_ns)) {
    as_stored.kind = Kind::kTooLate;
    return Take(entries, as_stored);
  }
  const bool is_gap = since_last > 0.0 && (recorded ? ContinuesClock(entries, 0)
                                                    : !next_good && since_last <= kLongestGap);
  if (is_gap) return Take(entries, TakeInOrder(entries));
  if (next_good || is_at_end) return Take(entries, Restamp(entries, next_good));
  return Take(entries, Resynchronise(entry));
}

}  // namespace radive
