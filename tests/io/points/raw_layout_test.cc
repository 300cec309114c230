// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/raw_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/io/points/field_matching.h"
#include "radive/io/scans/input_options.h"

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
  const std::optional<FieldMatch> match = MatchFields(layout->fields, {}, &error);
  if (!match) ADD_FAILURE() << error;
  std::vector<int> columns = {static_cast<int>(layout->record_size / 4)};
  for (const FieldRole role :
       {FieldRole::kX, FieldRole::kY, FieldRole::kZ, FieldRole::kDoppler, FieldRole::kPower}) {
    const int index = (*match)[role];
    columns.push_back(
        index < 0 ? -1
                  : static_cast<int>(layout->fields[static_cast<std::size_t>(index)].offset / 4));
  }
  return columns;
}

TEST(ParseRawLayout, KnowsTheNamedLayouts) {
  EXPECT_EQ(Columns("xyz3"), (std::vector<int>{3, 0, 1, 2, -1, -1}));
  EXPECT_EQ(Columns("vod7"), (std::vector<int>{7, 0, 1, 2, 4, 3}));
  EXPECT_EQ(Columns("xyzdp5"), (std::vector<int>{5, 0, 1, 2, 3, 4}));
  EXPECT_EQ(Columns("tj4d8"), (std::vector<int>{8, 0, 1, 2, 3, 5}));
}

TEST(ParseRawLayout, KnowsEveryNameThatItLists) {
  for (const std::string& name : RawLayoutNames()) {
    std::string error;
    EXPECT_TRUE(ParseRawLayout(name, &error)) << error;
  }
}

// Sizes from the datasets' own descriptions; the numbers in the names count bytes there.
TEST(ParseRawLayout, RecordsOfSeveralTypesHaveTheirSizes) {
  for (const auto& [name, size] : {std::pair("hercules29", 29u),
                                   std::pair("aeva29", 29u),
                                   std::pair("aeva25", 25u),
                                   std::pair("boreas_aeva40", 40u),
                                   std::pair("x:float64,y,z,rcs:uint16", 18u)}) {
    std::string error;
    const std::optional<RawLayout> layout = ParseRawLayout(name, &error);
    ASSERT_TRUE(layout) << error;
    EXPECT_EQ(layout->record_size, size) << name;
  }
}

TEST(ParseRawLayout, ReadsListsOfColumns) {
  EXPECT_EQ(Columns("x,y,z,doppler,power,_,_"), (std::vector<int>{7, 0, 1, 2, 3, 4}));
  EXPECT_EQ(Columns("[_, Z, Range_Rate, y, X]"), (std::vector<int>{5, 4, 3, 1, 2, -1}));
  EXPECT_EQ(Columns("x,y,SNR"), (std::vector<int>{3, 0, 1, -1, -1, 2}));
}

TEST(ParseRawLayout, SaysWhatIsWrong) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "found ''"},
      {"vod", "expected xyz3, xyzdp5, vod7, tj4d8, mscrad17"},
      {"x,y,z,dopler", "found 'dopler'"},
      {"x,y,z,v_r_compensated", "found 'v_r_compensated'"},
      {"x,y,,z", "found ''"},
      {"x,y,z,doppler,v_r", "'v_r' says the same as column 'doppler'"},
      {"y,z,doppler", "must have the columns x and y"},
      {"[x,y,z", "found '[x'"},
      {"x,y,z,rcs:char", "found 'rcs:char'"},
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

  for (const char* radar : {"0", "-1", "2.5", "front", "All"}) {
    options = InputOptions();
    options.radar = radar;
    EXPECT_FALSE(options.IsValid(&error)) << radar;
    EXPECT_THAT(error, HasSubstr("input.radar must be a number from 1, all or empty, is '"));
  }

  options = InputOptions();
  options.rate = -1.0;
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
