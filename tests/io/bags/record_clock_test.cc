// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/record_clock.h"

#include <gtest/gtest.h>

#include <vector>

namespace radive {
namespace {

// Times in seconds of one topic, in the order of the file.
bool WasSetBack(const std::vector<int>& seconds) {
  RecordClock clock;
  for (const int second : seconds) clock.Add(0, 1'000'000'000LL * second);
  return clock.WasSetBack();
}

TEST(RecordClock, TellsAClockThatWasSetFromOtherOrders) {
  EXPECT_FALSE(WasSetBack({}));
  EXPECT_FALSE(WasSetBack({100, 101, 102, 200}));
  EXPECT_FALSE(WasSetBack({100, 102, 101, 103}));                  // recorders mix up a little
  EXPECT_TRUE(WasSetBack({4000, 4001, 4002, 403, 404, 405}));      // by an hour
  EXPECT_TRUE(WasSetBack({100, 101, 102, 103, 93, 94, 95, 105}));  // by ten seconds
  EXPECT_FALSE(WasSetBack({104, 105, 106, 101, 102, 103}));        // parts that were joined
}

TEST(RecordClock, TopicsMayLieOneBehindTheOther) {
  RecordClock clock;
  for (const std::uint64_t topic : {0, 1}) {
    for (int second = 0; second < 100; ++second) clock.Add(topic, 1'000'000'000LL * second);
  }
  EXPECT_FALSE(clock.WasSetBack());
}

}  // namespace
}  // namespace radive
