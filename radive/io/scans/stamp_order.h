// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace radive {

// Decides from the stamps of a drive, in the order in which the scans were stored, which scan comes
// next and what its stamp is. Looks at most kReach scans ahead.
//
// A stamp that is after the last one by less than ten usual intervals (or 1 s) is taken as it is,
// and so is a gap. Otherwise the neighbours tell, and the time of recording where there is one:
//  - a scan among the next kReach whose stamp is earlier comes first: it was stored late;
//  - a stamp after which the others go on as before is bad. It is replaced by the time of
//    recording on the clock of the stamps, or lies evenly between its neighbours;
//  - where the stamps go on from there, the clock was set: all later stamps are moved so that they
//    go on behind the last one, by the time of recording or the usual interval. A counter that
//    wraps (32 bits of ns, us or ms; hour, day, GPS week) is such a clock;
//  - without a time of recording nothing tells a clock set forward from a gap: up to kLongestGap it
//    is taken for a gap.
class StampOrder {
 public:
  static constexpr std::size_t kReach = 8;        // scans
  static constexpr double kLongestGap = 86400.0;  // [s]

  struct Entry {
    std::int64_t stamp_ns = 0;
    std::optional<std::int64_t> record_ns;  // when it was recorded, by another clock
  };

  enum class Kind {
    kInOrder,
    kLate,      // was stored behind later ones
    kBadStamp,  // stamped anew
    kClockSet,  // the first behind a step of the clock; `shift_ns` says how far stamps are moved
                // now
    kRepeated,  // has the stamp of the scan before; the stamp is left as it is
    kTooLate    // belongs before scans that are gone; the stamp is left as it is
  };

  struct Decision {
    std::size_t position = 0;  // of the scan among the entries
    Kind kind = Kind::kInOrder;
    std::int64_t stamp_ns = 0;
    std::int64_t shift_ns = 0;  // that is added to the stored stamps
    bool by_record = false;     // a bad stamp was replaced by the time of recording
  };

  // `entries` are the scans that are left, in the order of storage: at least one, and kReach + 1
  // unless the drive ends.
  Decision Next(const std::deque<Entry>& entries);

 private:
  void Start(const std::deque<Entry>& entries);
  std::int64_t Shifted(const Entry& entry) const;
  double SinceLast(const Entry& entry) const;  // by the stamps [s]
  std::optional<double> RecordedSinceLast(const Entry& entry) const;
  bool IsNear(double since_last) const;
  bool ContinuesClock(const std::deque<Entry>& entries, std::size_t position) const;
  std::optional<std::size_t> Return(const std::deque<Entry>& entries) const;
  bool IsInHole(std::int64_t stamp_ns) const;
  Decision TakeInOrder(const std::deque<Entry>& entries);
  Decision Restamp(const std::deque<Entry>& entries, std::optional<std::size_t> next_good);
  Decision Resynchronise(const Entry& entry);
  Decision Take(const std::deque<Entry>& entries, Decision decision);

  bool has_started_ = false;
  std::int64_t shift_ns_ = 0;
  std::int64_t last_ns_ = 0;                    // stamp of the last scan, as given
  std::optional<std::int64_t> last_record_ns_;  // ... and when it was recorded
  double usual_interval_ = 0.0;                 // [s]
  std::deque<std::int64_t> recent_ns_;          // stamps given lately
};

}  // namespace radive
