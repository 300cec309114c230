// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/stamp_text.h"

#include <gtest/gtest.h>

namespace radive {
namespace {

TEST(ParseStamp, KeepsEveryNanosecond) {
  EXPECT_EQ(ParseStamp("1706001762.099999905"), 1706001762099999905);
  EXPECT_EQ(ParseStamp("1305031102.160407"), 1305031102160407000);
  EXPECT_EQ(ParseStamp("12"), 12000000000);
  EXPECT_EQ(ParseStamp("12."), 12000000000);
  EXPECT_EQ(ParseStamp(".5"), 500000000);
  EXPECT_EQ(ParseStamp("0"), 0);
  EXPECT_EQ(ParseStamp("-0.25"), -250000000);
  EXPECT_EQ(ParseStamp("+0.25"), 250000000);
}

TEST(ParseStamp, ReadsExponents) {
  EXPECT_EQ(ParseStamp("1.403715529112143517e+09"), 1403715529112143517);
  EXPECT_EQ(ParseStamp("1.2e9"), 1200000000000000000);
  EXPECT_EQ(ParseStamp("5E-1"), 500000000);
  EXPECT_EQ(ParseStamp("1e-400"), 0);
}

TEST(ParseStamp, RoundsToTheNearestNanosecond) {
  EXPECT_EQ(ParseStamp("1.0000000004"), 1000000000);
  EXPECT_EQ(ParseStamp("1.0000000005"), 1000000001);
  EXPECT_EQ(ParseStamp("-1.0000000005"), -1000000001);
  EXPECT_EQ(ParseStamp("0.0000000007"), 1);
  EXPECT_EQ(ParseStamp("0.00000000007"), 0);
}

TEST(ParseStamp, ReadsOtherUnits) {
  EXPECT_EQ(ParseStamp("1403715529107142912", -9), 1403715529107142912);
  EXPECT_EQ(ParseStamp("1.5", -3), 1500000);
}

TEST(ParseStamp, RejectsWhatIsNoStamp) {
  for (const char* text :
       {"", "-", ".", "abc", "1.2.3", "1e", "1ex", "nan", "inf", "1 2", "0x10"}) {
    EXPECT_EQ(ParseStamp(text), std::nullopt) << text;
  }
}

TEST(ParseStamp, RejectsWhatDoesNotFit) {
  EXPECT_EQ(ParseStamp("4611686018.427387904"), kLatestStamp);
  EXPECT_EQ(ParseStamp("4611686018.427387905"), std::nullopt);
  EXPECT_EQ(ParseStamp("-4611686018.4273879045"), std::nullopt);
  EXPECT_EQ(ParseStamp("1e300"), std::nullopt);
}

TEST(LooksLikeNanoseconds, MoreThanFifteenDigitsAndNothingElse) {
  EXPECT_TRUE(LooksLikeNanoseconds("1706001762099999905"));
  EXPECT_TRUE(LooksLikeNanoseconds("1234567890123456"));
  EXPECT_FALSE(LooksLikeNanoseconds("123456789012345"));
  EXPECT_FALSE(LooksLikeNanoseconds("1706001762.099999905"));
  // As NumPy prints whole numbers in a table.
  EXPECT_TRUE(LooksLikeNanoseconds("1.403636579758555392e+18"));
  EXPECT_FALSE(LooksLikeNanoseconds("1.706001762e9"));
}

TEST(FormatStamp, WritesNineDecimals) {
  EXPECT_EQ(FormatStamp(1706001762099999905), "1706001762.099999905");
  EXPECT_EQ(FormatStamp(5), "0.000000005");
  EXPECT_EQ(FormatStamp(-250000000), "-0.250000000");
  EXPECT_EQ(FormatStamp(-1250000000), "-1.250000000");
}

}  // namespace
}  // namespace radive
