// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/npy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/points/point_tables.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using testing::Floats;
using ::testing::HasSubstr;

std::string Npy(const std::string& dictionary, const std::string& data, int version = 1) {
  std::string bytes = "\x93NUMPY" + std::string(1, static_cast<char>(version)) + '\0';
  bytes += static_cast<char>(dictionary.size());
  bytes += std::string(version == 1 ? 1 : 3, '\0');
  return bytes + dictionary + data;
}

class NpyTest : public ::testing::Test {
 protected:
  bool Parse(const std::string& bytes) {
    bytes_ = bytes;
    remarks_.clear();
    return ParseNpy(bytes_, columns_, &table_, &remarks_, &error_);
  }
  std::vector<double> Values(const std::string& name) const {
    return testing::ValuesOf(table_, name);
  }

  std::vector<std::string> columns_;
  std::string bytes_;
  PointTable table_;
  std::vector<std::string> remarks_;
  std::string error_;
};

TEST_F(NpyTest, FiveColumnsAreThoseOfKRadar) {
  for (const int version : {1, 2}) {
    ASSERT_TRUE(Parse(Npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 5), }\n",
                          Floats({1, 2, 3, 40, -5, 6, 7, 8, 90, 10}),
                          version)))
        << error_;
    EXPECT_EQ(Values("z"), (std::vector<double>{3, 8}));
    EXPECT_EQ(Values("power"), (std::vector<double>{40, 90}));
    EXPECT_EQ(Values("doppler"), (std::vector<double>{-5, 10}));
  }
}

// Column by column, big-endian float64: 1.5 = 3FF8.., -2 = C000.., 0 and 0.
TEST_F(NpyTest, FortranOrderAndTheOtherByteOrder) {
  const std::string zero(8, '\0');
  const std::string data =
      std::string("\x3F\xF8\0\0\0\0\0\0", 8) + std::string("\xC0\0\0\0\0\0\0\0", 8) + zero + zero;
  columns_ = {"y", "x"};
  ASSERT_TRUE(Parse(Npy("{'descr':'>f8','fortran_order':True,'shape':(2,2)}", data))) << error_;
  EXPECT_EQ(Values("y"), (std::vector<double>{1.5, -2}));
  EXPECT_EQ(Values("x"), (std::vector<double>{0, 0}));
}

TEST_F(NpyTest, NamedColumns) {
  columns_ = {"_", "x", "y"};
  ASSERT_TRUE(
      Parse(Npy("{'descr': '<f4', 'fortran_order': False, 'shape': (1, 3)}", Floats({9, 1, 2}))));
  EXPECT_EQ(table_.fields.size(), 2u);
  EXPECT_EQ(Values("x"), std::vector<double>{1});
}

TEST_F(NpyTest, AFileThatEndsEarlyGivesWhatIsThere) {
  ASSERT_TRUE(Parse(Npy("{'descr': '<f4', 'fortran_order': False, 'shape': (99999999999, 3)}",
                        Floats({1, 2, 3, 4}))));
  EXPECT_EQ(table_.num_points, 1u);
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("promises 99999999999 points, the data hold 1")));
  EXPECT_FALSE(Parse(Npy("{'descr': '<f4', 'fortran_order': True, 'shape': (9, 3)}", "")));
}

TEST_F(NpyTest, SaysWhatIsWrong) {
  const std::pair<std::string, const char*> cases[] = {
      {"", "starts with \\x93NUMPY"},
      {"\x93NUMPX", "starts with \\x93NUMPY"},
      {Npy("{", "").substr(0, 9), "starts with"},
      {Npy(std::string(50, ' '), "").substr(0, 20), "cut off"},
      {Npy("{'descr': '<i4', 'fortran_order': False, 'shape': (2, 3)}", ""), "float32 or float64"},
      {Npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2,)}", ""), "two dimensions"},
      {Npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3, 4)}", ""), "two dimensions"},
      {Npy("{'descr': '<f4', 'fortran_order': None, 'shape': (2, 3)}", ""), "expected an array"},
      {Npy("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 8)}", ""), "input.layout"},
  };
  for (const auto& [bytes, message] : cases) {
    EXPECT_FALSE(Parse(bytes));
    EXPECT_THAT(error_, HasSubstr(message));
  }
}

}  // namespace
}  // namespace radive
