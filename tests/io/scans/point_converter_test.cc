// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/point_converter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/io/scan_files.h"

namespace radive {
namespace {

using testing::Floats;
using ::testing::HasSubstr;

class PointConverterTest : public ::testing::Test {
 protected:
  // Converts `bytes`, which hold `num_points` records of `table_`.
  bool Convert(const std::string& bytes, std::size_t num_points) {
    bytes_ = bytes;
    table_.data = bytes_.data();
    table_.num_points = num_points;
    return PointConverter(options_).Convert(table_, &scan_, &error_);
  }

  InputOptions options_;
  PointTable table_;
  std::string bytes_;
  RadarScan scan_;
  std::string error_;
};

TEST_F(PointConverterTest, ReadsPaddedFloat32ByOffset) {
  table_.fields = {{"z", NumericType::kFloat32, 8, 1},
                   {"y", NumericType::kFloat32, 4, 1},
                   {"x", NumericType::kFloat32, 0, 1},
                   {"doppler", NumericType::kFloat32, 16, 1}};
  table_.stride = 20;
  ASSERT_TRUE(Convert(Floats({3, 4, 12, 99, -7, 30, 40, 120, 99, 2}), 2)) << error_;
  ASSERT_EQ(scan_.returns.size(), 2u);
  EXPECT_EQ(scan_.returns[0].position, Eigen::Vector3d(3, 4, 12));
  EXPECT_EQ(scan_.returns[0].doppler, -7.0);
  EXPECT_EQ(scan_.returns[1].position, Eigen::Vector3d(30, 40, 120));
  EXPECT_EQ(scan_.returns[1].doppler, 2.0);
  EXPECT_TRUE(std::isnan(scan_.returns[1].power));
  EXPECT_TRUE(scan_.has_doppler);
  EXPECT_FALSE(scan_.is_planar);
}

// As RADIal has it: numbers of bins in "doppler", m/s in "v".
TEST_F(PointConverterTest, TakesTheFieldOfSpeedsNotThatOfBins) {
  for (const char* name : {"x", "y", "doppler", "v"}) {
    table_.AddField(name, NumericType::kFloat32);
  }
  ASSERT_TRUE(Convert(Floats({3, 4, 51, -7.6F, 30, 40, 127, 0}), 2)) << error_;
  EXPECT_FLOAT_EQ(static_cast<float>(scan_.returns[0].doppler), -7.6F);
  ASSERT_TRUE(Convert(Floats({3, 4, 51.5F, -7.6F, 30, 40, 127, 0}), 2)) << error_;
  EXPECT_EQ(scan_.returns[0].doppler, 51.5);
  options_.fields = "[doppler=doppler]";
  ASSERT_TRUE(Convert(Floats({3, 4, 51, -7.6F, 30, 40, 127, 0}), 2)) << error_;
  EXPECT_EQ(scan_.returns[0].doppler, 51.0);
}

// An empty scan first: the choice waits for points, and is kept for all scans.
TEST_F(PointConverterTest, ChoosesTheFieldOfSpeedsByTheFirstPoints) {
  for (const char* name : {"x", "y", "doppler", "v"}) {
    table_.AddField(name, NumericType::kFloat32);
  }
  PointConverter converter(options_);
  const std::vector<std::string> scans = {
      "", Floats({3, 4, 51, -7.6F}), Floats({3, 4, 127, 0}), Floats({3, 4, 2.5F, 1})};
  std::vector<double> dopplers;
  for (const std::string& bytes : scans) {
    table_.data = bytes.data();
    table_.num_points = bytes.size() / table_.stride;
    ASSERT_TRUE(converter.Convert(table_, &scan_, &error_)) << error_;
    for (const RadarReturn& ret : scan_.returns) dopplers.push_back(ret.doppler);
  }
  ASSERT_EQ(dopplers.size(), 3u);
  EXPECT_NEAR(dopplers[0], -7.6, 1e-6);
  EXPECT_EQ(dopplers[1], 0.0);
  EXPECT_EQ(dopplers[2], 1.0);
}

// Big-endian: int16 -2 = FF FE, uint16 65534 = FF FE, int32 -3, float64 1.5 = 3F F8 00.., int8 -1.
TEST_F(PointConverterTest, ReadsEveryTypeInTheOtherByteOrder) {
  table_.AddField("x", NumericType::kInt16);
  table_.AddField("y", NumericType::kUint16);
  table_.AddField("z", NumericType::kInt32);
  table_.AddField("v", NumericType::kFloat64);
  table_.AddField("rcs", NumericType::kInt8);
  table_.is_big_endian = true;
  ASSERT_EQ(table_.stride, 17u);
  const char record[] = "\xFF\xFE\xFF\xFE\xFF\xFF\xFF\xFD\x3F\xF8\0\0\0\0\0\0\xFF";
  options_.doppler_sign = InputOptions::DopplerSign::kMinus;
  ASSERT_TRUE(Convert(std::string(record, 17), 1)) << error_;
  EXPECT_EQ(scan_.returns[0].position, Eigen::Vector3d(-2, 65534, -3));
  EXPECT_EQ(scan_.returns[0].doppler, -1.5);
  EXPECT_EQ(scan_.returns[0].power, -1.0);
}

// Range 10 m, 90 deg to the left, 30 deg up: (0, 8.660, 5).
TEST_F(PointConverterTest, PolarPointsBecomePositions) {
  table_.AddField("range", NumericType::kFloat32);
  table_.AddField("azimuth_deg", NumericType::kFloat32);
  table_.AddField("elevation", NumericType::kFloat32);
  ASSERT_TRUE(Convert(Floats({10, 90, std::acos(-1.0) / 6}), 1)) << error_;
  EXPECT_NEAR((scan_.returns[0].position - Eigen::Vector3d(0, 8.660254, 5)).norm(), 0.0, 1e-5);
  EXPECT_FALSE(scan_.is_planar);
  options_.planar = true;
  ASSERT_TRUE(Convert(Floats({10, 90, 0.5}), 1)) << error_;
  EXPECT_NEAR((scan_.returns[0].position - Eigen::Vector3d(0, 10, 0)).norm(), 0.0, 1e-12);
  EXPECT_TRUE(scan_.is_planar);
}

// 60 degrees would be nine turns. A single one of many is a mark of what is invalid.
TEST_F(PointConverterTest, AnglesThatAreNoRadiansAreRefused) {
  table_.AddField("range", NumericType::kFloat32);
  table_.AddField("azimuth", NumericType::kFloat32);
  EXPECT_FALSE(Convert(Floats({10, 1, 10, -60, 10, 30}), 3));
  EXPECT_THAT(error_,
              HasSubstr("the azimuths go up to 60: degrees? Expected radians in 'azimuth'"));
  EXPECT_TRUE(scan_.returns.empty());
  EXPECT_TRUE(Convert(Floats({10, 1, 10, 6.28, 10, -3.1, 10, 99}), 4)) << error_;
  EXPECT_EQ(scan_.returns.size(), 4u);
}

TEST_F(PointConverterTest, FieldsBeyondTheRecordAreRefused) {
  table_.fields = {{"x", NumericType::kFloat32, 0, 1}, {"y", NumericType::kFloat64, 4, 1}};
  table_.stride = 8;
  EXPECT_FALSE(Convert(std::string(8, '\0'), 1));
  EXPECT_THAT(error_, HasSubstr("field 'y' at byte 4 reaches beyond the record of 8 bytes"));
  table_.fields[1] = {"y", NumericType::kUint8, 7, ~std::size_t{0}};
  EXPECT_FALSE(Convert(std::string(8, '\0'), 1));
  table_.fields[1] = {"y", NumericType::kUint8, ~std::size_t{0}, 1};
  EXPECT_FALSE(Convert(std::string(8, '\0'), 1));
}

TEST_F(PointConverterTest, SummarisesTheFields) {
  table_.AddField("x", NumericType::kFloat32);
  table_.AddField("y", NumericType::kFloat32);
  table_.AddField("temperature", NumericType::kFloat32);
  bytes_ = Floats({1, -2, 20, 5, NAN, 25});
  table_.data = bytes_.data();
  table_.num_points = 2;
  PointConverter converter(options_);
  ASSERT_TRUE(converter.Convert(table_, &scan_, &error_));
  const std::vector<FieldSummary> fields = converter.Summaries();
  ASSERT_EQ(fields.size(), 3u);
  EXPECT_EQ(fields[0].role, "x");
  EXPECT_EQ(fields[0].min, 1.0);
  EXPECT_EQ(fields[0].max, 5.0);
  EXPECT_EQ(fields[1].num_not_finite, 1u);
  EXPECT_EQ(fields[1].max, -2.0);
  EXPECT_EQ(fields[2].role, "");
  EXPECT_EQ(fields[2].max, 25.0);
  EXPECT_EQ(fields[2].type, "float32");
}

}  // namespace
}  // namespace radive
