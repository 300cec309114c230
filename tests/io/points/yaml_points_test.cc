// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/yaml_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/io/points/point_tables.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class YamlPointsTest : public ::testing::Test {
 protected:
  bool Parse(const std::string& text) {
    remarks_.clear();
    return ParseYamlPoints(text, &table_, &remarks_, &error_);
  }
  std::vector<double> Values(const std::string& name) const {
    return testing::ValuesOf(table_, name);
  }

  PointTable table_;
  std::vector<std::string> remarks_;
  std::string error_;
};

TEST_F(YamlPointsTest, ReadsAListOfFlatMaps) {
  ASSERT_TRUE(
      Parse("header:\n  stamp:\n    sec: 17\norigin_yaw: 0.5\ndetections:\n"
            "  - range: 10.5\n    valid: true\n    rcs: -10\n"
            "  - rcs: 3\n    range: 20\n    other: 9\n"));
  EXPECT_EQ(Values("range"), (std::vector<double>{10.5, 20}));
  EXPECT_EQ(Values("rcs"), (std::vector<double>{-10, 3}));
  EXPECT_EQ(Values("valid")[0], 1.0);
  EXPECT_TRUE(std::isnan(Values("valid")[1]));
  EXPECT_EQ(table_.fields.size(), 3u);
  EXPECT_THAT(remarks_, IsEmpty());
}

TEST_F(YamlPointsTest, TheListEndsWhereTheIndentDoes) {
  ASSERT_TRUE(Parse("- x: 1\n  nested:\n    x: 7\n- x: 2\nend: 3\n"));
  EXPECT_EQ(Values("x"), (std::vector<double>{1, 2}));
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("line 5: what follows the list")));
}

TEST_F(YamlPointsTest, WithoutAListThereAreNoPoints) {
  for (const char* text : {"", "a: 1\nb: 2\n", "- \n-\n", "\t\n:"}) {
    EXPECT_FALSE(Parse(text)) << text;
    EXPECT_THAT(error_, HasSubstr("expected a list of points"));
  }
}

}  // namespace
}  // namespace radive
