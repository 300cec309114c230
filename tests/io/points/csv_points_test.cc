// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/csv_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/io/points/point_tables.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class CsvPointsTest : public ::testing::Test {
 protected:
  bool Parse(const std::string& text) {
    remarks_.clear();
    return ParseCsvPoints(text, &table_, &remarks_, &error_);
  }
  std::vector<double> Values(const std::string& name) const {
    return testing::ValuesOf(table_, name);
  }

  PointTable table_;
  std::vector<std::string> remarks_;
  std::string error_;
};

TEST_F(CsvPointsTest, EachDelimiter) {
  for (const char* text : {"x,y,doppler\n1,2,-3.5\n4,5,6\n",
                           "x;y;doppler\r\n1;2;-3.5\r\n4;5;6",
                           "# a remark\nx\ty\tdoppler\n\n1\t2\t-3.5\n# another\n4\t5\t6\n",
                           "x  y doppler\n1 2   -3.5 \n 4 5 6\n",
                           "# x y doppler\n1 2 -3.5\n4 5 6\n",
                           "\xEF\xBB\xBF\"x\", \"y\", \"doppler\"\n1, 2, -3.5\n4, 5, 6\n"}) {
    ASSERT_TRUE(Parse(text)) << text << error_;
    EXPECT_EQ(Values("x"), (std::vector<double>{1, 4})) << text;
    EXPECT_EQ(Values("doppler"), (std::vector<double>{-3.5, 6})) << text;
    EXPECT_THAT(remarks_, IsEmpty());
  }
}

TEST_F(CsvPointsTest, CellsThatAreNoNumbersAreNan) {
  ASSERT_TRUE(Parse("x,y,label\n1,,car\n2,3,4\n5,6\n"));
  EXPECT_TRUE(std::isnan(Values("y")[0]));
  EXPECT_TRUE(std::isnan(Values("label")[0]));
  EXPECT_EQ(Values("x"), (std::vector<double>{1, 2}));
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("1 lines do not have 3 cells")));
}

TEST_F(CsvPointsTest, NamesAreNeeded) {
  for (const char* text : {"", "\n\n", "1,2,3\n4,5,6\n"}) {
    EXPECT_FALSE(Parse(text)) << text;
    EXPECT_THAT(error_, HasSubstr("expected the names of the columns"));
  }
}

}  // namespace
}  // namespace radive
