// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/config/setting_text.h"

#include <gtest/gtest.h>

namespace radive {
namespace {

TEST(ParseSettingText, TellsWordsQuotesAndListsApart) {
  const SettingText word = ParseSettingText(" paper ");
  EXPECT_FALSE(word.is_list);
  EXPECT_EQ(word.words, std::vector<std::string>{"paper"});
  const SettingText quoted = ParseSettingText("\"a, b\"");
  EXPECT_TRUE(quoted.is_quoted);
  EXPECT_EQ(quoted.words, std::vector<std::string>{"a, b"});
  const SettingText list = ParseSettingText("[1, 2.5,3]");
  EXPECT_TRUE(list.is_list);
  EXPECT_EQ(list.words, (std::vector<std::string>{"1", "2.5", "3"}));
  EXPECT_TRUE(ParseSettingText("[]").words.empty());
}

TEST(AssignField, TakesNumbersInFullOnly) {
  double value = 1.0;
  OptionField field{"x", &value, "m", "A length."};
  std::string error;
  for (const char* good : {"2", "-2.5", "+1e-3", ".5", "7."}) {
    EXPECT_TRUE(AssignField("s", ParseSettingText(good), &field, &error)) << good;
  }
  EXPECT_EQ(value, 7.0);
  for (const char* bad : {"", "2m", "nan", "0x10", "1,5", "1e999", "--1", "[1]", "\"1\""}) {
    EXPECT_FALSE(AssignField("s", ParseSettingText(bad), &field, &error)) << bad;
  }
  EXPECT_EQ(value, 7.0);
}

TEST(AssignField, TakesWholeNumbersForIntegersOnly) {
  int value = 1;
  OptionField field{"n", &value, "-", "A count."};
  std::string error;
  EXPECT_TRUE(AssignField("s", ParseSettingText("-12"), &field, &error));
  EXPECT_EQ(value, -12);
  for (const char* bad : {"1.5", "1e3", "99999999999", "", "true"}) {
    EXPECT_FALSE(AssignField("s", ParseSettingText(bad), &field, &error)) << bad;
  }
  EXPECT_EQ(error, "s.n must be a whole number, is true");
}

TEST(AssignField, ChecksSizeAndEntriesOfLists) {
  std::vector<double> value = {1.0, 2.0, 3.0};
  OptionField field = OptionField{"offset", &value, "m", "An offset."}.Size(3).AtLeast(0.0);
  std::string error;
  EXPECT_TRUE(AssignField("s", ParseSettingText("[4,5,6.5]"), &field, &error)) << error;
  EXPECT_EQ(value, (std::vector<double>{4.0, 5.0, 6.5}));
  EXPECT_FALSE(AssignField("s", ParseSettingText("[4,5]"), &field, &error));
  EXPECT_EQ(error, "s.offset must be 3 numbers, each >= 0 m, is [4, 5]");
  EXPECT_FALSE(AssignField("s", ParseSettingText("[1,2,-3]"), &field, &error));
  EXPECT_FALSE(AssignField("s", ParseSettingText("4"), &field, &error));
  EXPECT_EQ(error, "s.offset must be a list like [1, 2.5, 3], 3 numbers, each >= 0, is 4");
}

TEST(NearestWord, FindsTyposAndLeavesStrangersAlone) {
  EXPECT_EQ(NearestWord("d_mxa", {"d_min", "d_max"}), "d_max");
  EXPECT_EQ(NearestWord("normalization", {"normalisation", "d_max"}), "normalisation");
  EXPECT_EQ(NearestWord("banana", {"d_min", "d_max"}), std::nullopt);
  EXPECT_EQ(NearestWord("ab", {"cd"}), std::nullopt);
}

}  // namespace
}  // namespace radive
