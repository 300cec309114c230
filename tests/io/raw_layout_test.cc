// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/raw_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/io/input_options.h"

namespace radive {
namespace {

using ::testing::HasSubstr;

// The columns in the order count, x, y, z, doppler, power.
std::vector<int> Columns(const std::string& text) {
  std::string error;
  const std::optional<RawLayout> layout = ParseRawLayout(text, &error);
  if (!layout) {
    ADD_FAILURE() << error;
    return {};
  }
  return {layout->num_columns, layout->x, layout->y, layout->z, layout->doppler, layout->power};
}

TEST(ParseRawLayout, KnowsTheNamedLayouts) {
  EXPECT_EQ(Columns("xyz3"), (std::vector<int>{3, 0, 1, 2, -1, -1}));
  EXPECT_EQ(Columns("vod7"), (std::vector<int>{7, 0, 1, 2, 4, 3}));
  EXPECT_EQ(Columns("xyzdp5"), (std::vector<int>{5, 0, 1, 2, 3, 4}));
  EXPECT_EQ(Columns("tj4d8"), (std::vector<int>{8, 0, 1, 2, 3, 5}));
}

TEST(ParseRawLayout, ReadsListsOfColumns) {
  EXPECT_EQ(Columns("x,y,z,doppler,power,_,_"), (std::vector<int>{7, 0, 1, 2, 3, 4}));
  EXPECT_EQ(Columns("[_, Z, Range_Rate, y, X]"), (std::vector<int>{5, 4, 3, 1, 2, -1}));
  EXPECT_EQ(Columns("x,y,SNR"), (std::vector<int>{3, 0, 1, -1, -1, 2}));
}

TEST(ParseRawLayout, SaysWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "found ''"},
      {"vod", "expected xyz3, vod7, xyzdp5, tj4d8"},
      {"x,y,z,dopler", "found 'dopler'"},
      {"x,y,z,v_r_compensated", "found 'v_r_compensated'"},
      {"x,y,,z", "found ''"},
      {"x,y,z,doppler,v_r", "'v_r' says the same as column 4"},
      {"y,z,doppler", "must have the columns x and y"},
      {"[x,y,z", "found '[x'"},
  };
  for (const auto& [text, message] : cases) {
    std::string error;
    EXPECT_FALSE(ParseRawLayout(text, &error)) << text;
    EXPECT_THAT(error, HasSubstr(message));
    EXPECT_THAT(error, HasSubstr("layout '" + text + "'"));
  }
}

TEST(InputOptions, DefaultsAreValid) {
  std::string error;
  EXPECT_TRUE(InputOptions().IsValid(&error)) << error;
}

TEST(InputOptions, NameTheFieldThatIsWrong) {
  std::string error;
  InputOptions options;
  options.layout = "x,y,dopler";
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_THAT(error, HasSubstr("input.layout 'x,y,dopler'"));

  for (const char* radar : {"", "0", "-1", "2.5", "front", "All"}) {
    options = InputOptions();
    options.radar = radar;
    EXPECT_FALSE(options.IsValid(&error)) << radar;
    EXPECT_THAT(error, HasSubstr("input.radar must be a number from 1, or all, is '"));
  }

  options = InputOptions();
  options.rate = 0.0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_THAT(error, HasSubstr("input.rate"));
}

TEST(InputOptions, SignIsAppliedOnlyWhenItIsFixed) {
  InputOptions options;
  EXPECT_EQ(options.FixedDopplerSign(), 1.0);
  options.doppler_sign = InputOptions::DopplerSign::kPlus;
  EXPECT_EQ(options.FixedDopplerSign(), 1.0);
  options.doppler_sign = InputOptions::DopplerSign::kMinus;
  EXPECT_EQ(options.FixedDopplerSign(), -1.0);
}

}  // namespace
}  // namespace radive
