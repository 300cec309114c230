// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/pcd.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/bytes/lzf.h"
#include "tests/io/points/parser_test.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using testing::Floats;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class PcdTest : public testing::ParserTest<decltype(&ParsePcd)> {
 protected:
  PcdTest() : ParserTest(&ParsePcd) {}
};

constexpr char kHeader[] =
    "# .PCD v.7\nVERSION .7\nFIELDS x y z v\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\n"
    "WIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\n";

TEST_F(PcdTest, Ascii) {
  ASSERT_TRUE(Parse(kHeader + std::string("DATA ascii\n1 2 3 -4.5\r\nnan 6e1 7 8\n"))) << error_;
  ASSERT_EQ(table_.num_points, 2u);
  EXPECT_EQ(Values("v"), (std::vector<double>{-4.5, 8.0}));
  EXPECT_EQ(Values("y"), (std::vector<double>{2.0, 60.0}));
  EXPECT_TRUE(std::isnan(Values("x")[1]));
  EXPECT_THAT(remarks_, IsEmpty());
}

TEST_F(PcdTest, Binary) {
  ASSERT_TRUE(Parse(kHeader + std::string("DATA binary\n") + Floats({1, 2, 3, -4, 5, 6, 7, 8})));
  EXPECT_EQ(Values("x"), (std::vector<double>{1.0, 5.0}));
  EXPECT_EQ(Values("v"), (std::vector<double>{-4.0, 8.0}));
  EXPECT_THAT(remarks_, IsEmpty());
}

// Padding called _, several numbers a field, other types, COUNT left out in the second header.
TEST_F(PcdTest, TypesAndPadding) {
  ASSERT_TRUE(
      Parse("FIELDS x _ n y\nSIZE 8 1 2 1\nTYPE F U U I\nCOUNT 1 3 2 1\nWIDTH 1\nHEIGHT 1\n"
            "POINTS 1\nDATA binary\n" +
            std::string("\0\0\0\0\0\0\xF8\x3F"
                        "abc"
                        "\x02\x01\xFF\xFF"
                        "\xFE",
                        16)))
      << error_;
  EXPECT_EQ(table_.stride, 16u);
  EXPECT_EQ(table_.fields.size(), 3u);
  EXPECT_EQ(Values("x"), std::vector<double>{1.5});
  EXPECT_EQ(Values("n"), std::vector<double>{258.0});
  EXPECT_EQ(Values("y"), std::vector<double>{-2.0});
  ASSERT_TRUE(Parse("FIELDS x y\nSIZE 1 1\nTYPE U U\nPOINTS 1\nDATA binary\n\x03\x04"));
  EXPECT_EQ(Values("y"), std::vector<double>{4.0});
}

// Columns 00 00 80 3F (1.0) twice, then 2.0 and 3.0: a literal of 4, a repeat of 4 from 4 before,
// a literal of 8.
TEST_F(PcdTest, Compressed) {
  const std::string header = "FIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 2\nDATA binary_compressed\n";
  const std::string stream = "\x03" + Floats({1}) + std::string("\x40\x03\x07") + Floats({2, 3});
  std::string sizes;
  AppendLittleEndian(static_cast<std::uint32_t>(stream.size()), &sizes);
  AppendLittleEndian(std::uint32_t{16}, &sizes);
  ASSERT_TRUE(Parse(header + sizes + stream)) << error_;
  EXPECT_EQ(Values("x"), (std::vector<double>{1.0, 1.0}));
  EXPECT_EQ(Values("y"), (std::vector<double>{2.0, 3.0}));
  EXPECT_FALSE(Parse(header + sizes + stream.substr(1)));
  EXPECT_THAT(error_, HasSubstr("expected compressed data of 2 points of 8 bytes"));
}

// The SNAIL-Radar tools copy SIZE from the message but pack every value as float32.
TEST_F(PcdTest, DeclaredSizesThatDoNotFitAreReadAsFloat32) {
  ASSERT_TRUE(
      Parse("FIELDS x y flag\nSIZE 4 4 2\nTYPE F F U\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n"
            "DATA binary\n" +
            Floats({1, 2, 3, 4, 5, 6})));
  EXPECT_EQ(Values("flag"), (std::vector<double>{3.0, 6.0}));
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("every field is read as float32")));
}

TEST_F(PcdTest, ThePayloadIsRightAboutTheNumberOfPoints) {
  ASSERT_TRUE(Parse(kHeader + std::string("DATA binary\n") + Floats({1, 2, 3, -4, 5, 6})));
  EXPECT_EQ(table_.num_points, 1u);
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("promises 2 points, the data hold 1")));
  ASSERT_TRUE(
      Parse("FIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 99999999999\nHEIGHT 99999999999\n"
            "DATA binary\n" +
            Floats({1, 2})));
  EXPECT_EQ(table_.num_points, 1u);
  ASSERT_TRUE(Parse(kHeader + std::string("DATA ascii\n1 2 3 4\n5 6")));
  EXPECT_EQ(table_.num_points, 1u);
  EXPECT_EQ(remarks_.size(), 2u);
}

// Found by fuzzing, as arithmetic on a null pointer.
TEST_F(PcdTest, CompressedDataMayHoldNothing) {
  ASSERT_TRUE(
      Parse("FIELDS x y\nSIZE 4 4\nTYPE F F\nDATA binary_compressed\n" + std::string(8, '\0')));
  EXPECT_EQ(table_.num_points, 0u);
}

TEST_F(PcdTest, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "line 1: the header of a PCD file ends without a DATA line"},
      {"FIELDS x y\nSIZE 4 4\n", "ends without a DATA line"},
      {"FIELDS x y\nWIDTH one\n", "line 2: expected a line of a PCD header"},
      {"DATA binary\n", "as many entries in SIZE, TYPE and COUNT as in FIELDS"},
      {"FIELDS x y\nSIZE 4\nTYPE F F\nDATA binary\n", "found 1, 2 and 0 for 2"},
      {"FIELDS x\nSIZE 3\nTYPE F\nDATA binary\n", "field 'x': expected TYPE F, U or I"},
      {"FIELDS x\nSIZE 4\nTYPE F\nCOUNT 0\nDATA binary\n", "COUNT from 1"},
      {"FIELDS x\nSIZE 4\nTYPE F\nDATA zip\n", "line 4: expected a line of a PCD header"},
      {"FIELDS x\nSIZE 4\nTYPE F\nDATA ascii\none\n", "line 1 of the data: expected a number"},
      {"FIELDS x\nSIZE 4\nTYPE F\nDATA binary_compressed\nabc", "the two sizes"},
  };
  for (const auto& [text, message] : cases) {
    EXPECT_FALSE(Parse(text)) << text;
    EXPECT_THAT(error_, HasSubstr(message));
  }
}

TEST(Lzf, GivesBackWhatWasPacked) {
  std::string bytes;
  for (int i = 0; i < 20000; ++i) bytes += static_cast<char>((i * i) >> 6);
  bytes += std::string(5000, 'a');
  const std::string packed = PackLzf(bytes);
  EXPECT_LT(packed.size(), bytes.size());
  std::vector<char> unpacked;
  std::string error;
  ASSERT_TRUE(UnpackLzf(packed, bytes.size(), &unpacked, &error)) << error;
  EXPECT_EQ(std::string(unpacked.begin(), unpacked.end()), bytes);
  EXPECT_FALSE(UnpackLzf(packed, bytes.size() - 1, &unpacked, &error));
  EXPECT_FALSE(UnpackLzf(packed, bytes.size() + 1, &unpacked, &error));
}

TEST(Lzf, RefusesWhatCannotBe) {
  std::vector<char> unpacked;
  std::string error;
  EXPECT_FALSE(
      UnpackLzf("\x01"
                "a",
                2,
                &unpacked,
                &error));
  EXPECT_THAT(error, HasSubstr("its end is missing"));
  EXPECT_FALSE(UnpackLzf(std::string("\x20\x00", 2), 3, &unpacked, &error));
  EXPECT_THAT(error, HasSubstr("no LZF stream"));
  EXPECT_FALSE(UnpackLzf("abc", std::size_t{1} << 40, &unpacked, &error));
  EXPECT_THAT(error, HasSubstr("3 compressed bytes cannot hold"));
}

// Lower case, keys of other programs, a byte order mark and the line ends of Windows do no harm.
TEST_F(PcdTest, HeadersOfOtherWriters) {
  ASSERT_TRUE(
      Parse("\xEF\xBB\xBF# made elsewhere\r\nversion .7\r\nfields x y\r\nsize 4 4\r\ntype f F\r\n"
            "count 1 1\r\nwidth 2\r\nheight 1\r\nTIMESTAMP 17\r\npoints 2\r\ndata Binary\r\n" +
            Floats({1, 2, 3, 4})))
      << error_;
  EXPECT_EQ(Values("y"), (std::vector<double>{2.0, 4.0}));
  EXPECT_THAT(remarks_, IsEmpty());
}

// Old and new words of Microsoft's library for numbers that are none.
TEST_F(PcdTest, WordsForNoNumber) {
  ASSERT_TRUE(Parse(
      "FIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 4\nDATA ascii\n1.#QNAN 1\n-1.#IND 2\n-nan(ind) 3\n"
      "-1.#INF00 4\n"))
      << error_;
  EXPECT_EQ(Values("y"), (std::vector<double>{1, 2, 3, 4}));
  for (const std::size_t i : {0u, 1u, 2u}) EXPECT_TRUE(std::isnan(Values("x")[i])) << i;
  EXPECT_EQ(Values("x")[3], -HUGE_VAL);
  EXPECT_THAT(remarks_, IsEmpty());
}

// The points behind a bad line are as good as those before it.
TEST_F(PcdTest, BadLinesAreLeftOut) {
  ASSERT_TRUE(Parse("FIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 4\nDATA ascii\n1 2\n3,5 4\n5\n7 8\n"));
  EXPECT_EQ(Values("x"), (std::vector<double>{1, 7}));
  EXPECT_THAT(remarks_,
              ElementsAre(HasSubstr("line 2 of the data: expected a number for each field, found "
                                    "'3,5 4'; 2 such lines are left out"),
                          HasSubstr("promises 4 points, the data hold 2")));
}

// POINTS and WIDTH times HEIGHT contradict each other: what the data hold is right.
TEST_F(PcdTest, CountsThatContradictEachOther) {
  const std::string fields = "FIELDS x y\nSIZE 4 4\nTYPE F F\n";
  ASSERT_TRUE(Parse(fields + "WIDTH 1\nHEIGHT 1\nPOINTS 2\nDATA ascii\n1 2\n3 4\n"));
  EXPECT_EQ(table_.num_points, 2u);
  EXPECT_THAT(remarks_, IsEmpty());
  ASSERT_TRUE(Parse(fields + "WIDTH 2\nHEIGHT 1\nPOINTS 1\nDATA binary\n" + Floats({1, 2, 3, 4})));
  EXPECT_EQ(table_.num_points, 2u);
  EXPECT_THAT(remarks_, IsEmpty());
  ASSERT_TRUE(Parse(fields + "POINTS 1\nDATA ascii\n1 2\n3 4\n"));
  EXPECT_EQ(table_.num_points, 1u);
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("1 lines behind the last point are ignored")));
}

}  // namespace
}  // namespace radive
