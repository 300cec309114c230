// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/scan_stamps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/io/bytes/stamp_text.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ParseStampOfScan, KeepsEveryDigit) {
  EXPECT_EQ(ParseStamp("0.145249"), 145249000);
  EXPECT_EQ(ParseStamp("12"), 12000000000);
  EXPECT_EQ(ParseStamp("12."), 12000000000);
  EXPECT_EQ(ParseStamp(".5"), 500000000);
  EXPECT_EQ(ParseStamp("-0.25"), -250000000);
  EXPECT_EQ(ParseStamp("+0.25"), 250000000);
  // A double is 2.4e-7 s apart here and would lose the last digits.
  EXPECT_EQ(ParseStamp("1693922345.123456789"), 1693922345123456789);
  EXPECT_EQ(ParseStamp("9223372036.854775806"), 9223372036854775806);
}

TEST(ParseStampOfScan, RoundsBeyondNanoseconds) {
  EXPECT_EQ(ParseStamp("0.0000000014"), 1);
  EXPECT_EQ(ParseStamp("0.0000000015"), 2);
  EXPECT_EQ(ParseStamp("0.9999999999"), 1000000000);
  EXPECT_EQ(ParseStamp("0.00000000001"), 0);
}

TEST(ParseStampOfScan, ReadsExponents) {
  EXPECT_EQ(ParseStamp("1.452490000000000000e-01"), 145249000);
  EXPECT_EQ(ParseStamp("1.5E+2"), 150000000000);
  EXPECT_EQ(ParseStamp("5e-10"), 1);
  EXPECT_EQ(ParseStamp("4e-10"), 0);
  EXPECT_EQ(ParseStamp("3e-99"), 0);
}

TEST(ParseStampOfScan, RefusesEverythingElse) {
  for (const char* text : {"",
                           ".",
                           "-",
                           "1.2.3",
                           "1,2",
                           "abc",
                           "nan",
                           "inf",
                           "0x10",
                           "1e",
                           "1e+-2",
                           "e5",
                           " 1",
                           "1 2",
                           "9223372036.854775808",
                           "1e30",
                           "1e999999999999"}) {
    EXPECT_FALSE(ParseStamp(text)) << text;
  }
}

TEST(ParseInteger, RefusesWhatIsNoInteger) {
  EXPECT_EQ(ParseInteger("-12"), -12);
  EXPECT_EQ(ParseInteger("9223372036854775807"), 9223372036854775807);
  for (const char* text : {"", "-", "+1", "1.0", "1e3", "12a", " 1", "9223372036854775808"}) {
    EXPECT_FALSE(ParseInteger(text)) << text;
  }
}

TEST(StampOfStem, TellsUnitsByTheNumberOfDigits) {
  EXPECT_EQ(StampOfStem("1693922345123456789"), 1693922345123456789);
  EXPECT_EQ(StampOfStem("1693922345123456"), 1693922345123456000);
  EXPECT_EQ(StampOfStem("1693922345123"), 1693922345123000000);
  EXPECT_EQ(StampOfStem("1706001762.099999905"), 1706001762099999905);
  for (const char* text : {"",
                           "000549",
                           "0693922345123456789",
                           "1693922345",
                           "-169392234512",
                           "1693922345.12",
                           "1693922345.12345678x",
                           "1.693922345.123456789",
                           "9999999999999999",  // beyond the year 2262
                           "9999999999999",
                           "9999999999999999999"}) {
    EXPECT_FALSE(StampOfStem(text)) << text;
  }
}

class ReadStampFileTest : public ::testing::Test {
 protected:
  bool Read(const std::string& content) {
    folder_.Write("times.txt", content);
    return ReadStampFile(folder_.path() / "times.txt", &stamps_, &error_);
  }
  testing::TempFolder folder_;
  std::vector<std::int64_t> stamps_;
  std::string error_;
};

TEST_F(ReadStampFileTest, IntegersAreNanoseconds) {
  ASSERT_TRUE(Read("1693922345123456789\n0\n-5")) << error_;
  EXPECT_THAT(stamps_, ElementsAre(1693922345123456789, 0, -5));
}

TEST_F(ReadStampFileTest, OneDecimalPointMakesAllSeconds) {
  ASSERT_TRUE(Read("\xEF\xBB\xBF# time\r\n1\r\n\r\n  1.1 \r\n2e0\r\n")) << error_;
  EXPECT_THAT(stamps_, ElementsAre(1000000000, 1100000000, 2000000000));
}

TEST_F(ReadStampFileTest, SaysFileAndLineOfWhatItCannotRead) {
  ASSERT_FALSE(Read("0.1\n# remark\n0.2 0.3\n"));
  EXPECT_THAT(error_, HasSubstr((folder_.path() / "times.txt:3").string()));
  EXPECT_THAT(error_, HasSubstr("expected one stamp"));
  EXPECT_THAT(error_, HasSubstr("'0.2 0.3'"));
}

TEST_F(ReadStampFileTest, NamesAnUnfetchedFile) {
  ASSERT_FALSE(Read(testing::LfsPointer()));
  EXPECT_THAT(error_, HasSubstr("times.txt: a Git-LFS pointer"));
}

}  // namespace
}  // namespace radive
