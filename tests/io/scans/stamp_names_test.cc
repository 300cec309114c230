// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/stamp_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

namespace radive {
namespace {

using ::testing::ElementsAre;

std::vector<std::int64_t> Stamps(const std::vector<std::string>& stems) {
  std::optional<std::size_t> odd;
  const std::optional<StampSequence> sequence = StampsOfNames(stems, &odd);
  EXPECT_FALSE(odd);
  return sequence ? sequence->stamps_ns : std::vector<std::int64_t>();
}

constexpr std::int64_t kBegin = 1700000000000000000;  // 2023-11-14 22:13:20 UTC

TEST(StampsOfNames, TellsUnitsByTheNumberOfDigits) {
  EXPECT_THAT(Stamps({"1693922345123456789"}), ElementsAre(1693922345123456789));
  EXPECT_THAT(Stamps({"1693922345123456"}), ElementsAre(1693922345123456000));
  EXPECT_THAT(Stamps({"1693922345123"}), ElementsAre(1693922345123000000));
  EXPECT_THAT(Stamps({"1706001762.099999905"}), ElementsAre(1706001762099999905));
  EXPECT_THAT(Stamps({"1700000000.5", "1700000000.75"}),
              ElementsAre(kBegin + 500000000, kBegin + 750000000));
}

TEST(StampsOfNames, ReadsSecondsWithARest) {
  EXPECT_THAT(Stamps({"1700000000.123456", "1700000000.223456"}),
              ElementsAre(kBegin + 123456000, kBegin + 223456000));
  EXPECT_THAT(Stamps({"1700000000_005000000", "1700000000_105000000"}),
              ElementsAre(kBegin + 5000000, kBegin + 105000000));
  // Without leading zeros, as printed by "%d_%d".
  EXPECT_THAT(Stamps({"1700000000_5000000", "1700000000_105000000"}),
              ElementsAre(kBegin + 5000000, kBegin + 105000000));
  EXPECT_THAT(Stamps({"1700000000-005000", "1700000000-105000"}),
              ElementsAre(kBegin + 5000000, kBegin + 105000000));
  EXPECT_THAT(Stamps({"radar_1700000000_000", "radar_1700000000_100"}),
              ElementsAre(kBegin, kBegin + 100000000));
}

TEST(StampsOfNames, FindsTheStampAmongOtherNumbers) {
  EXPECT_THAT(Stamps({"radar_1700000000000000000", "radar_1700000000100000000"}),
              ElementsAre(kBegin, kBegin + 100000000));
  EXPECT_THAT(Stamps({"n015-2018-07-24-11-22-45+0800__RADAR_FRONT__1532402927647951",
                      "n015-2018-07-24-11-22-45+0800__RADAR_FRONT__1532402927720123"}),
              ElementsAre(1532402927647951000, 1532402927720123000));
  EXPECT_THAT(Stamps({"000000_1700000000.100000", "000001_1700000000.200000"}),
              ElementsAre(kBegin + 100000000, kBegin + 200000000));
}

TEST(StampsOfNames, ReadsDates) {
  EXPECT_THAT(Stamps({"2023-11-14-22-13-20.100", "2023-11-14-22-13-20.200"}),
              ElementsAre(kBegin + 100000000, kBegin + 200000000));
  EXPECT_THAT(Stamps({"20231114_221320_100", "20231114_221320_200"}),
              ElementsAre(kBegin + 100000000, kBegin + 200000000));
  EXPECT_THAT(Stamps({"20231114221320100", "20231114221320200"}),
              ElementsAre(kBegin + 100000000, kBegin + 200000000));
}

TEST(StampsOfNames, ReadsSecondsFromTheStart) {
  EXPECT_THAT(Stamps({"0.05", "0.1", "0.15"}), ElementsAre(50000000, 100000000, 150000000));
}

TEST(StampsOfNames, PositionsAreNoStamps) {
  for (const std::vector<std::string>& stems :
       {std::vector<std::string>{"000549", "000550"},
        std::vector<std::string>{"0693922345123456789"},
        std::vector<std::string>{"scan"},
        std::vector<std::string>{"9999999999999999"},  // beyond the year 2262
        std::vector<std::string>{"2023-11-14_000012", "2023-11-14_000013"},
        std::vector<std::string>{"2023-11-14-22-13-20_12", "2023-11-14-22-13-20_13", "a_14"},
        std::vector<std::string>{"1.0", "2.0", "3.0.1"}}) {
    std::optional<std::size_t> odd;
    EXPECT_FALSE(StampsOfNames(stems, &odd)) << stems[0];
  }
}

TEST(StampsOfNames, NamesTheOneWithoutAStamp) {
  std::optional<std::size_t> odd;
  EXPECT_FALSE(StampsOfNames({"1700000000000000000", "calibration", "1700000000100000000"}, &odd));
  EXPECT_EQ(odd, 1u);
}

}  // namespace
}  // namespace radive
