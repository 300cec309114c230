// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/points/parser_test.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using testing::Floats;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class PlyTest : public testing::ParserTest<decltype(&ParsePly)> {
 protected:
  PlyTest() : ParserTest(&ParsePly) {}
};

constexpr char kVertices[] =
    "element vertex 2\nproperty float x\nproperty float y\nproperty double v_r\nend_header\n";

TEST_F(PlyTest, Ascii) {
  ASSERT_TRUE(Parse("ply\nformat ascii 1.0\ncomment made by hand\n" + std::string(kVertices) +
                    "1 2 -3.5\n4 5 6\n"))
      << error_;
  EXPECT_EQ(Values("x"), (std::vector<double>{1, 4}));
  EXPECT_EQ(Values("v_r"), (std::vector<double>{-3.5, 6}));
  EXPECT_THAT(remarks_, IsEmpty());
}

// 1.5 = 3FF8000000000000
TEST_F(PlyTest, BothByteOrders) {
  const std::string little = std::string("\0\0\0\0\0\0\xF8\x3F", 8);
  const std::string big(little.rbegin(), little.rend());
  ASSERT_TRUE(Parse("ply\nformat binary_little_endian 1.0\n" + std::string(kVertices) +
                    Floats({1, 2}) + little + Floats({3, 4}) + little));
  EXPECT_EQ(Values("x"), (std::vector<double>{1, 3}));
  EXPECT_EQ(Values("v_r"), (std::vector<double>{1.5, 1.5}));
  const std::string one("\x3F\x80\0\0", 4);  // 1.0
  ASSERT_TRUE(Parse("ply\r\nformat binary_big_endian 1.0\r\n" + std::string(kVertices) + one + one +
                    big + one + one + big));
  EXPECT_EQ(Values("y"), (std::vector<double>{1, 1}));
  EXPECT_EQ(Values("v_r"), (std::vector<double>{1.5, 1.5}));
}

TEST_F(PlyTest, ElementsBeforeAndListsArePassedOver) {
  const std::string header =
      " 1.0\nelement face 2\nproperty list uchar int vertex_indices\nelement camera 1\nproperty "
      "float view\nelement vertex 2\nproperty uchar x\nproperty list ushort float "
      "weights\nproperty "
      "char y\nend_header\n";
  ASSERT_TRUE(Parse("ply\nformat binary_little_endian" + header +
                    std::string("\x01\x09\0\0\0"
                                "\x00"
                                "camr"
                                "\x05\x01\0wwww\xFF"
                                "\x06\0\0\x02",
                                5 + 1 + 4 + 8 + 4)))
      << error_;
  EXPECT_EQ(Values("x"), (std::vector<double>{5, 6}));
  EXPECT_EQ(Values("y"), (std::vector<double>{-1, 2}));
  ASSERT_TRUE(Parse("ply\nformat ascii" + header + "1 9\n0\n0.5\n5 1 0.1 -1\n6 0 2\n"));
  EXPECT_EQ(Values("x"), (std::vector<double>{5, 6}));
  EXPECT_EQ(Values("y"), (std::vector<double>{-1, 2}));
}

TEST_F(PlyTest, AFileThatEndsEarlyGivesWhatIsThere) {
  ASSERT_TRUE(Parse("ply\nformat ascii 1.0\n" + std::string(kVertices) + "1 2 3\n4 5\n"));
  EXPECT_EQ(table_.num_points, 1u);
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("promises 2 points, the data hold 1")));
  ASSERT_TRUE(
      Parse("ply\nformat binary_big_endian 1.0\nelement vertex 18446744073709551615\n"
            "property uchar x\nproperty uchar y\nend_header\nabcde"));
  EXPECT_EQ(table_.num_points, 2u);
}

// As a file with bytes inserted has them; elements behind the vertices are nobody's concern.
TEST_F(PlyTest, SaysThatBytesAreLeftOver) {
  ASSERT_TRUE(Parse("ply\nformat ascii 1.0\n" + std::string(kVertices) + "1 2 3\n4 5 6\n7\n \n"));
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("4 bytes behind the last point")));
  const std::string header =
      "ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\n";
  ASSERT_TRUE(Parse(header + "end_header\nabcd"));
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("2 bytes behind the last point")));
  ASSERT_TRUE(Parse(header + "element face 1\nproperty uchar z\nend_header\nabc"));
  EXPECT_THAT(remarks_, IsEmpty());
}

TEST_F(PlyTest, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "line 1: expected 'ply'"},
      {"plyx\n", "line 1: expected 'ply'"},
      {"ply\nformat ascii 1.0\n", "line 3: expected a line of a PLY header"},
      {"ply\nformat zip 1.0\n", "line 2: expected a line of a PLY header"},
      {"ply\nproperty float x\n", "line 2"},
      {"ply\nelement vertex -1\n", "line 2"},
      {"ply\nelement vertex 1\nproperty half x\n", "line 3"},
      {"ply\nformat ascii 1.0\nend_header\n", "no element vertex"},
      {"ply\nelement face 3\nproperty int a\nelement vertex 1\nproperty int x\nend_header\nabc",
       "the data end within the element 'face'"},
  };
  for (const auto& [text, message] : cases) {
    EXPECT_FALSE(Parse(text)) << text;
    EXPECT_THAT(error_, HasSubstr(message));
  }
}

// Elements without properties take no bytes: as many as the header likes, in no time.
TEST_F(PlyTest, EmptyElementsEndAtOnce) {
  EXPECT_TRUE(
      Parse("ply\nformat ascii 1.0\nelement nothing 18446744073709551615\nelement vertex "
            "0\nproperty float x\nend_header\n"));
  EXPECT_TRUE(Parse("ply\nformat ascii 1.0\nelement vertex 18446744073709551615\nend_header\n"));
  EXPECT_EQ(table_.num_points, 0u);
}

TEST_F(PlyTest, HeadersOfOtherWriters) {
  ASSERT_TRUE(
      Parse("\xEF\xBB\xBFPLY\r\nFORMAT ascii 1.0\r\nobj_info scan 7\r\nsensor front\r\n"
            "element Vertex 2\r\nproperty float x\r\nproperty FLOAT y\r\nproperty bool valid\r\n"
            "property int64 stamp\r\nend_header\r\n1 2 1 17\r\n3 4 0 18\r\n"))
      << error_;
  EXPECT_EQ(Values("y"), (std::vector<double>{2.0, 4.0}));
  EXPECT_EQ(Values("valid"), (std::vector<double>{1.0, 0.0}));
  EXPECT_EQ(Values("stamp"), (std::vector<double>{17.0, 18.0}));
  EXPECT_FALSE(Parse("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n1\n"));
  EXPECT_THAT(error_, HasSubstr("line 4: expected"));
}

}  // namespace
}  // namespace radive
