// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/number_text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>

#include "radive/util/random.h"
#include "tests/foreign_locales.h"

namespace radive {
namespace {

std::string Printed(const char* form, double value) {
  char text[500];
  std::snprintf(text, sizeof(text), form, value);
  return text;
}

// Any double: every bit pattern is as likely as another.
double AnyDouble(Random* random) {
  const std::uint64_t bits = random->Bits();
  double value = 0.0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

TEST(FormatText, IsWhatPrintfPrints) {
  EXPECT_EQ(FormatText("%.3f m, %d of %s", 2.0 / 3.0, 7, "9"), "0.667 m, 7 of 9");
  EXPECT_EQ(FormatText("%s", std::string(1000, 'x').c_str()), std::string(1000, 'x'));
  EXPECT_EQ(FormatText("%.9f", 1e300).size(), 311U);
  EXPECT_EQ(NumberText(0.25), "0.250000");
}

TEST(FormatText, IsTheSameInEveryLocale) {
  const testing::ForeignLocales locales;
  if (!locales.are_there()) GTEST_SKIP() << "no package `locales`";
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const double value = AnyDouble(&random);
    for (const char* form : {"%.9f", "%.9g", "%.17g", "%.4f"}) {
      std::setlocale(LC_ALL, "C");
      const std::string expected = Printed(form, value);
      std::setlocale(LC_ALL, i % 2 == 0 ? "de_DE.UTF-8" : "fr_FR.UTF-8");
      ASSERT_EQ(FormatText(form, value), expected);
    }
  }
  EXPECT_EQ(Printed("%.1f", 0.5), "0,5");  // the locale of the thread is as it was
}

TEST(ShortText, IsWhatPrintfPrints) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double value : {0.0,
                             -0.0,
                             1.0,
                             -2.5,
                             1.0 / 3.0,
                             123456789.125,
                             1e9,
                             1e10,
                             1e-5,
                             1e-300,
                             -9.99999999949e7,
                             1e308,
                             infinity,
                             -infinity,
                             std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(ShortText(value), FormatText("%.9g", value));
  }
}

TEST(ParseDouble, ReadsBackWhatIsPrinted) {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const double value = AnyDouble(&random);
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(ParseDouble(FormatText("%.17g", value)), value);
  }
  EXPECT_EQ(ParseDouble("0.25"), 0.25);
  EXPECT_EQ(ParseDouble("+1e3"), 1000.0);
  EXPECT_EQ(ParseDouble("0,25"), std::nullopt);
  EXPECT_EQ(ParseDouble(" 1"), std::nullopt);
  EXPECT_EQ(ParseDouble(""), std::nullopt);
  EXPECT_EQ(ParseDouble("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(ParseDouble("1e-999"), 0.0);
}

TEST(ParseInt, TakesWholeNumbersWithinBounds) {
  EXPECT_EQ(ParseInt("-2147483648"), std::numeric_limits<int>::min());
  EXPECT_EQ(ParseInt("+2147483647"), std::numeric_limits<int>::max());
  for (const char* text : {"", "+", "-", "+-1", "2147483648", "1.0", "1 ", "0x1"}) {
    EXPECT_EQ(ParseInt(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace radive
