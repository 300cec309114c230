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
                           "x,y,doppler\r1,2,-3.5\r4,5,6\r",
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
  EXPECT_THAT(
      remarks_,
      ElementsAre(HasSubstr("1 lines do not have 3 cells"),
                  HasSubstr("line 2: expected a number in the column 'label', found 'car'")));
  ASSERT_TRUE(Parse("x,y,label\n1,n/a,car\n2,-,van\n"));
  EXPECT_THAT(remarks_, IsEmpty()) << "labels, and cells that stand for no value";
}

TEST_F(CsvPointsTest, NamesAreNeeded) {
  for (const char* text : {"", "\n\n", "1,2,3\n4,5,6\n"}) {
    EXPECT_FALSE(Parse(text)) << text;
    EXPECT_THAT(error_, HasSubstr("expected the names of the columns"));
  }
}

// As a German Excel writes it; quotes keep a comma in its cell.
TEST_F(CsvPointsTest, DecimalCommasWhereTheySeparateNothing) {
  for (const char* text : {"x;y;doppler\n1,25;-2,5;0,5\n3;4;-1e-1\n",
                           "sep=;\nx;y;doppler\n1,25;-2,5;0,5\n3;4;-0,1\n",
                           "x\ty\tdoppler\n1,25\t-2,5\t0,5\n3\t4\t-0,1\n",
                           "x,y,doppler\n\"1,25\",\"-2,5\",\"0,5\"\n3,4,-0.1\n"}) {
    ASSERT_TRUE(Parse(text)) << text << error_;
    EXPECT_EQ(Values("x"), (std::vector<double>{1.25, 3})) << text;
    EXPECT_EQ(Values("y"), (std::vector<double>{-2.5, 4})) << text;
    EXPECT_EQ(Values("doppler"), (std::vector<double>{0.5, -0.1})) << text;
    EXPECT_THAT(remarks_, IsEmpty());
  }
  EXPECT_FALSE(Parse("x,y,doppler\n1,25,-2,5,0,5\n"));
  EXPECT_THAT(error_, HasSubstr("line 2: expected 3 cells, found 6: '1,25,-2,5,0,5'"));
  EXPECT_THAT(error_, HasSubstr("decimal commas are only read where"));
}

// Numbers of rows as R and pandas write them, a delimiter at the end of the lines, comments.
TEST_F(CsvPointsTest, ColumnsWithoutNames) {
  for (const char* text : {"x,y,doppler\n1,5,6,7\n2,8,9,10\n",
                           ",x,y,doppler\n0,5,6,7\n1,8,9,10\n",
                           "x,y,doppler\n5,6,7,\n8,9,10,\n",
                           "x,y,doppler,\n5,6,7\n8,9,10\n",
                           "% made by hand\nx,y,doppler\n5,6,7\n// half time\n8,9,10\n"}) {
    ASSERT_TRUE(Parse(text)) << text << error_;
    EXPECT_EQ(Values("x"), (std::vector<double>{5, 8})) << text;
    EXPECT_EQ(Values("doppler"), (std::vector<double>{7, 10})) << text;
  }
}

TEST_F(CsvPointsTest, WordsInColumnsThatAreUsed) {
  EXPECT_FALSE(Parse("x [m],y,doppler\n1,2,slow\n3,4,fast\n"));
  EXPECT_THAT(error_, HasSubstr("line 2: expected a number in the column 'doppler', found 'slow'"));
  ASSERT_TRUE(Parse("x,y,doppler\n1,2,slow\n3,4,5\n"));
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("found 'slow'; 1 such cells are taken as missing")));
  EXPECT_TRUE(std::isnan(Values("doppler")[0]));
}

TEST_F(CsvPointsTest, TablesOfPosesAreNoPoints) {
  for (const char* text : {"t,x,y,z,qx,qy,qz,qw\n0,1,2,3,0,0,0,1\n",
                           "time,x,y,z,roll [deg],pitch [deg],yaw [deg]\n0,1,2,3,0,0,0\n",
                           "time,latitude,longitude\n0,1,2\n"}) {
    EXPECT_FALSE(Parse(text)) << text;
    EXPECT_THAT(error_, HasSubstr("expected points"));
  }
}

}  // namespace
}  // namespace radive
