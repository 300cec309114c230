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
  EXPECT_EQ(ParseStamp("4611686018.427387903"), 4611686018427387903);
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
                           "4611686018.427387905",
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

class ReadStampFileTest : public ::testing::Test {
 protected:
  bool Read(const std::string& content) {
    folder_.Write("times.txt", content);
    const auto sequence = ReadStampFile(folder_.path() / "times.txt", kAssumedRate, &error_);
    if (sequence) stamps_ = sequence->stamps_ns;
    return sequence.has_value();
  }
  testing::TempFolder folder_;
  std::vector<std::int64_t> stamps_;
  std::string error_;
};

TEST_F(ReadStampFileTest, IntegersAreNanosecondsWhereNothingTells) {
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

TEST_F(ReadStampFileTest, FindsTheStampsAmongTheColumns) {
  const std::int64_t begin = 1700000000000000000;
  for (const char* content :
       {"0 1700000000.0\n1 1700000000.1\n2 1700000000.2\n",
        "index,time\n0,1700000000.0\n1,1700000000.1\n2,1700000000.2\n",
        "1700000000 0\n1700000000 100000000\n1700000000 200000000\n",
        "timestamp\n1700000000000\n1700000000100\n1700000000200\n",
        "2023-11-14 22:13:20.0\n2023-11-14 22:13:20.1\n2023-11-14 22:13:20.2"}) {
    ASSERT_TRUE(Read(content)) << content << error_;
    EXPECT_THAT(stamps_, ElementsAre(begin, begin + 100000000, begin + 200000000)) << content;
  }
  // Two clocks: which one is meant?
  EXPECT_FALSE(Read("0.0 1700000000.0\n0.1 1700000000.1\n0.2 1700000000.2\n"));
}

TEST_F(ReadStampFileTest, NamesAnUnfetchedFile) {
  ASSERT_FALSE(Read(testing::LfsPointer()));
  EXPECT_THAT(error_, HasSubstr("times.txt: a Git-LFS pointer"));
}

TEST(ParseStampLines, SecondsAndTheRestInTheUnitThatItsDigitsSay) {
  const auto stamps = [](const std::string& text) {
    std::string error;
    const auto sequence = ParseStampLines(text, /*is_trajectory=*/false, 0.0, "times.txt", &error);
    EXPECT_TRUE(sequence) << error;
    return sequence ? sequence->stamps_ns : std::vector<std::int64_t>();
  };
  const auto expected =
      ElementsAre(1700000000'900000000LL, 1700000001'000000000LL, 1700000001'050000000LL);
  EXPECT_THAT(stamps("1700000000 900000000\n1700000001 0\n1700000001 50000000\n"), expected);
  EXPECT_THAT(stamps("1700000000 900000\n1700000001 0\n1700000001 50000\n"), expected);
  EXPECT_THAT(stamps("1700000000,900\n1700000001,0\n1700000001,50\n"), expected);
  // A decimal comma.
  EXPECT_THAT(stamps("1700000000,900000\n1700000001,000000\n1700000001,050000\n"), expected);
}

}  // namespace
}  // namespace radive
