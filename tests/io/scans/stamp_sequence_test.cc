// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/stamp_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "radive/io/bytes/stamp_text.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

StampSequence Read(const std::vector<std::string_view>& texts, double rate = 0.0) {
  std::size_t bad = 0;
  const std::optional<StampSequence> sequence = ReadStampSequence(texts, rate, &bad);
  EXPECT_TRUE(sequence) << "text " << bad;
  return sequence.value_or(StampSequence());
}

constexpr std::int64_t kMs = 1'000'000;

TEST(ReadStampSequence, TellsTheUnitByTheDate) {
  for (const std::vector<std::string_view>& texts :
       {std::vector<std::string_view>{"1700000000000000000", "1700000000100000000"},
        std::vector<std::string_view>{"1700000000000000", "1700000000100000"},
        std::vector<std::string_view>{"1700000000000", "1700000000100"},
        std::vector<std::string_view>{"1700000000.0", "1700000000.1"},
        std::vector<std::string_view>{"1700000000000.0", "1700000000100.0"},
        std::vector<std::string_view>{"1.7000000000e+09", "1.7000000001e+09"}}) {
    const StampSequence sequence = Read(texts);
    EXPECT_EQ(sequence.stamps_ns[0], 1700000000000000000) << texts[0];
    EXPECT_EQ(sequence.stamps_ns[1], 1700000000100000000) << texts[1];
    EXPECT_EQ(sequence.doubt, "") << texts[0];
  }
}

// Of numbers without any limit the differences stay within 64 bits.
TEST(ReadStampSequence, TakesStampsOfAnySize) {
  const StampSequence sequence = Read({"0e4451", "0e4154", "0e4115", "-5e49", "5e49", "1"});
  ASSERT_EQ(sequence.stamps_ns.size(), 6U);
  for (const std::int64_t stamp_ns : sequence.stamps_ns) {
    EXPECT_LE(std::abs(stamp_ns), kLatestStamp);
  }
}

TEST(ReadStampSequence, TellsTheUnitByTheInterval) {
  EXPECT_THAT(Read({"0", "100000000", "200000000"}).stamps_ns,
              ElementsAre(0, 100 * kMs, 200 * kMs));
  EXPECT_THAT(Read({"0", "66667", "133333"}).stamps_ns, ElementsAre(0, 66667000, 133333000));
  EXPECT_THAT(Read({"5000", "5050", "5101"}).stamps_ns,
              ElementsAre(5000 * kMs, 5050 * kMs, 5101 * kMs));
  EXPECT_THAT(Read({"0", "0.1", "0.2"}).stamps_ns, ElementsAre(0, 100 * kMs, 200 * kMs));
  EXPECT_THAT(Read({"0.0", "100.0", "200.0"}).stamps_ns, ElementsAre(0, 100 * kMs, 200 * kMs));
  EXPECT_THAT(Read({"-0.2", "-0.1", "0"}).stamps_ns, ElementsAre(-200 * kMs, -100 * kMs, 0));
}

// 28 minutes since the radar was switched on, which as seconds would be the year 2023.
TEST(ReadStampSequence, AnIntervalCountsMoreThanADate) {
  const StampSequence sequence = Read({"1700000000", "1700050000", "1700100000"});
  EXPECT_EQ(sequence.unit, "us");
  EXPECT_EQ(sequence.stamps_ns[0], 1700000 * kMs);
}

TEST(ReadStampSequence, BadStampsDoNotChangeTheUnit) {
  EXPECT_EQ(Read({"0",
                  "0",
                  "0",
                  "1700000000100000",
                  "1700000000200000",
                  "1700000000300000",
                  "9999999999999999",
                  "1700000000500000",
                  "1700000000600000",
                  "1700000000700000"})
                .unit,
            "us");
}

TEST(ReadStampSequence, CountersNeedARate) {
  const StampSequence scans = Read({"0", "1", "2"});
  EXPECT_TRUE(scans.rate_is_used);
  EXPECT_THAT(scans.stamps_ns, ElementsAre(0, 100 * kMs, 200 * kMs));
  EXPECT_THAT(scans.doubt, HasSubstr("count the scans"));
  // Camera images at 30 Hz beside a radar at 15 Hz; one scan is missing.
  EXPECT_THAT(Read({"12", "14", "16", "20"}, 15.0).stamps_ns,
              ElementsAre(0, 66666667, 133333333, 266666667));
  EXPECT_TRUE(Read({"0.0", "1.0", "2.0"}).rate_is_used);
  // Whole seconds with a date are seconds.
  EXPECT_FALSE(Read({"1700000000", "1700000001", "1700000002"}).rate_is_used);
}

TEST(ReadStampSequence, FrozenStampsAreNone) {
  const StampSequence sequence = Read({"1.7e+09", "1.7e+09", "1.7e+09"}, 20.0);
  EXPECT_TRUE(sequence.rate_is_used);
  EXPECT_THAT(sequence.stamps_ns, ElementsAre(0, 50 * kMs, 100 * kMs));
  EXPECT_THAT(sequence.doubt, HasSubstr("all stamps are 1.7e+09"));
}

// Whole seconds of a radar with 4 Hz that began 0.5 s before a full second: 0.25 s apart.
TEST(ReadStampSequence, SpreadsStampsThatLostTheirPrecision) {
  const StampSequence sequence = Read({"1700000000",
                                       "1700000000",
                                       "1700000001",
                                       "1700000001",
                                       "1700000001",
                                       "1700000001",
                                       "1700000002",
                                       "1700000002"});
  const std::int64_t second = 1700000001000000000;
  EXPECT_THAT(sequence.stamps_ns,
              ElementsAre(second - 500 * kMs,
                          second - 250 * kMs,
                          second,
                          second + 250 * kMs,
                          second + 500 * kMs,
                          second + 750 * kMs,
                          second + 1000 * kMs,
                          second + 1250 * kMs));
  EXPECT_THAT(sequence.doubt, HasSubstr("spread evenly"));
  // Single-precision floats of seconds since 1970 are 128 s apart.
  EXPECT_TRUE(Read({"1.7e9", "1.7e9", "1.7e9", "1.700000128e9", "1.700000128e9"}).rate_is_used);
}

TEST(ReadStampSequence, SaysWhenNoUnitFits) {
  const StampSequence sequence = Read({"0", "5000000000", "10000000000"});
  EXPECT_EQ(sequence.unit, "ns");
  EXPECT_THAT(sequence.doubt, HasSubstr("5 s apart"));
}

TEST(ParseDate, ReadsKittiAndIso) {
  EXPECT_EQ(ParseDate("2011-09-26 13:02:25.594360375"), 1317042145594360375);
  EXPECT_EQ(ParseDate("2023-11-14T22:13:20Z"), 1700000000000000000);
  EXPECT_EQ(ParseDate("2023/11/14-22_13_20.5"), 1700000000500000000);
  for (const char* text : {"2011-09-26",
                           "2011-13-26 13:02:25",
                           "1700000000.5",
                           "2011-09-26 25:02:25",
                           "2011-09-26 13:02:25.",
                           "2011-09-26 13:02:25.5x",
                           ""}) {
    EXPECT_FALSE(ParseDate(text)) << text;
  }
}

}  // namespace
}  // namespace radive
