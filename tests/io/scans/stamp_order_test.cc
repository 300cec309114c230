// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/stamp_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::Pointwise;
using Kind = StampOrder::Kind;

// What becomes of a drive: which scans come in which order, with which stamps.
struct Outcome {
  std::vector<int> order;      // indices in the order of storage
  std::vector<double> stamps;  // of these [s]
  std::vector<Kind> kinds;     // that are not kInOrder
};

// Scans with these stamps, recorded at these times [s].
Outcome Play(const std::vector<double>& stamps, const std::vector<double>& records = {}) {
  std::deque<StampOrder::Entry> left;
  std::deque<int> indices;
  const auto nanoseconds = [](double seconds) { return std::llround(seconds * 1e9); };
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    StampOrder::Entry entry;
    entry.stamp_ns = nanoseconds(stamps[i]);
    if (!records.empty()) entry.record_ns = nanoseconds(records[i]);
    left.push_back(entry);
    indices.push_back(static_cast<int>(i));
  }
  StampOrder order;
  Outcome outcome;
  while (!left.empty()) {
    const auto size = static_cast<std::ptrdiff_t>(std::min(left.size(), StampOrder::kReach + 1));
    const StampOrder::Decision decision =
        order.Next(std::deque<StampOrder::Entry>(left.begin(), left.begin() + size));
    const auto position = static_cast<std::ptrdiff_t>(decision.position);
    outcome.order.push_back(indices[decision.position]);
    outcome.stamps.push_back(static_cast<double>(decision.stamp_ns) * 1e-9);
    if (decision.kind != Kind::kInOrder) outcome.kinds.push_back(decision.kind);
    left.erase(left.begin() + position);
    indices.erase(indices.begin() + position);
  }
  return outcome;
}

// 0, 0.1, 0.2, ... from `first` on.
std::vector<double> Regular(int count, double first = 0.0) {
  std::vector<double> stamps;
  for (int i = 0; i < count; ++i) stamps.push_back(first + 0.1 * i);
  return stamps;
}

MATCHER_P(IsWithin, tolerance, "") {
  return std::abs(std::get<0>(arg) - std::get<1>(arg)) <= tolerance;
}

void ExpectStamps(const Outcome& outcome, const std::vector<double>& expected) {
  EXPECT_THAT(outcome.stamps, Pointwise(IsWithin(1e-6), expected));
}

TEST(StampOrder, LeavesWhatIsInOrder) {
  std::vector<double> stamps = Regular(30, 100.0);
  stamps[7] += 0.04;                                        // jitter
  for (std::size_t i = 12; i < 30; ++i) stamps[i] += 0.3;   // lost scans
  for (std::size_t i = 20; i < 30; ++i) stamps[i] += 60.0;  // a gap
  const Outcome outcome = Play(stamps);
  ExpectStamps(outcome, stamps);
  EXPECT_TRUE(outcome.kinds.empty());
  std::vector<double> early_gap = {0.0, 0.1, 0.2, 60.0, 60.1, 60.2, 60.3, 60.4, 60.5, 60.6, 60.7};
  ExpectStamps(Play(early_gap), early_gap);
  ExpectStamps(Play(stamps, stamps), stamps);
}

TEST(StampOrder, PutsLateScansInOrder) {
  const Outcome swapped = Play({0.0, 0.1, 0.3, 0.2, 0.4, 0.5});
  EXPECT_THAT(swapped.order, ElementsAre(0, 1, 3, 2, 4, 5));
  ExpectStamps(swapped, Regular(6));
  EXPECT_THAT(swapped.kinds, ElementsAre(Kind::kLate));
  const Outcome first = Play({0.1, 0.0, 0.2, 0.3, 0.4});
  EXPECT_THAT(first.order, ElementsAre(1, 0, 2, 3, 4));
  const Outcome four_late = Play({0.0, 0.2, 0.3, 0.4, 0.5, 0.1, 0.6, 0.7});
  EXPECT_THAT(four_late.order, ElementsAre(0, 5, 1, 2, 3, 4, 6, 7));
  ExpectStamps(four_late, Regular(8));
}

TEST(StampOrder, PassesOverWhatComesTooLate) {
  std::vector<double> stamps = Regular(30);
  stamps.erase(stamps.begin() + 5);
  stamps.insert(stamps.begin() + 20, 0.5);
  const Outcome outcome = Play(stamps);
  EXPECT_THAT(outcome.kinds, ElementsAre(Kind::kTooLate));
  EXPECT_EQ(outcome.order[20], 20);
}

TEST(StampOrder, StampsBadOnesBetweenTheirNeighbours) {
  for (const double bad : {0.0, 1e8, -5.0, 9.9}) {
    std::vector<double> stamps = Regular(20, 3.0);
    stamps[9] = bad;
    stamps[10] = bad;
    const Outcome outcome = Play(stamps);
    ExpectStamps(outcome, Regular(20, 3.0));
    EXPECT_THAT(outcome.kinds, ElementsAre(Kind::kBadStamp, Kind::kBadStamp)) << bad;
  }
}

TEST(StampOrder, StampsTheFirstOnesBackwards) {
  std::vector<double> stamps = Regular(20, 1.7e9);
  stamps[0] = stamps[1] = stamps[2] = 0.0;
  const Outcome outcome = Play(stamps);
  ExpectStamps(outcome, Regular(20, 1.7e9));
  EXPECT_EQ(outcome.kinds.size(), 3u);
}

// A clock that is 50 s behind that of the recorder; the scan at 0.9 has a bad stamp, and its
// recording says that it was 20 ms early.
TEST(StampOrder, TakesTheTimeOfRecordingOnTheClockOfTheStamps) {
  std::vector<double> stamps = Regular(20), records = Regular(20, 50.0);
  stamps[9] = 1e6;
  records[9] -= 0.02;
  std::vector<double> expected = Regular(20);
  expected[9] -= 0.02;
  ExpectStamps(Play(stamps, records), expected);
}

TEST(StampOrder, FollowsAClockThatWasSet) {
  for (const double step : {-3600.0, -0.3, -2.0, 86400.0 * 365, -1e9}) {
    std::vector<double> stamps = Regular(30, 10.0);
    for (std::size_t i = 15; i < 30; ++i) stamps[i] += step;
    const Outcome outcome = Play(stamps);
    ExpectStamps(outcome, Regular(30, 10.0));
    EXPECT_THAT(outcome.kinds, ElementsAre(Kind::kClockSet)) << step;
  }
}

// Without a witness an hour forward is a gap; the recording tells that it is none, and that half a
// second passed where the clock was set back.
TEST(StampOrder, TheTimeOfRecordingIsAWitness) {
  std::vector<double> stamps = Regular(30);
  for (std::size_t i = 15; i < 30; ++i) stamps[i] += 3600.0;
  ExpectStamps(Play(stamps), stamps);
  const Outcome forward = Play(stamps, Regular(30, 7.0));
  ExpectStamps(forward, Regular(30));
  EXPECT_THAT(forward.kinds, ElementsAre(Kind::kClockSet));

  std::vector<double> back = Regular(30), records = Regular(30, 7.0), expected = Regular(30);
  for (std::size_t i = 15; i < 30; ++i) {
    back[i] -= 100.0;
    records[i] += 0.4;
    expected[i] += 0.4;
  }
  ExpectStamps(Play(back, records), expected);
  // A real gap stays.
  for (std::size_t i = 15; i < 30; ++i) records[i] = 3607.0 + 0.1 * static_cast<double>(i);
  ExpectStamps(Play(stamps, records), stamps);
}

// 32 bits of microseconds end at 4294.967296 s, where the next scan comes after 0.13 s.
TEST(StampOrder, UnwrapsCounters) {
  std::vector<double> stamps = Regular(10, 4294.0), expected = stamps;
  for (int i = 0; i < 10; ++i) {
    stamps.push_back(4294.9 + 0.13 - 4294.967296 + 0.1 * i);
    expected.push_back(4294.9 + 0.13 + 0.1 * i);
  }
  ExpectStamps(Play(stamps), expected);
}

TEST(StampOrder, RepeatedStamps) {
  // The same scan twice: nothing is missing.
  std::vector<double> stamps = Regular(20);
  stamps.insert(stamps.begin() + 5, 0.5);
  EXPECT_THAT(Play(stamps).kinds, ElementsAre(Kind::kRepeated));
  // A stamp that was not renewed: the next is two intervals away.
  stamps = Regular(20);
  stamps[6] = stamps[5];
  const Outcome stuck = Play(stamps);
  ExpectStamps(stuck, Regular(20));
  EXPECT_THAT(stuck.kinds, ElementsAre(Kind::kBadStamp));
  // Two clouds of one scan, recorded a millisecond apart.
  std::vector<double> twice, records;
  for (int i = 0; i < 10; ++i) {
    for (const double later : {0.0, 0.001}) {
      twice.push_back(0.1 * i);
      records.push_back(5.0 + 0.1 * i + later);
    }
  }
  const Outcome pairs = Play(twice, records);
  EXPECT_EQ(pairs.kinds, std::vector<Kind>(10, Kind::kRepeated));
}

}  // namespace
}  // namespace radive
