// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/preprocessing/preprocess.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "radive/geometry/spherical.h"
#include "radive/preprocessing/azimuth_bin_filter.h"
#include "radive/preprocessing/field_of_view_filter.h"
#include "radive/util/angle_units.h"
#include "radive/util/random.h"

namespace radive {
namespace {

using ::testing::ElementsAre;

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A return with its number as power, so that tests can say which ones are left.
RadarReturn At(double range, double azimuth_deg, double elevation_deg, double number) {
  RadarReturn entry;
  entry.position = FromSpherical({range, azimuth_deg * kDegree, elevation_deg * kDegree});
  entry.doppler = 0.0;
  entry.power = number;
  return entry;
}

std::vector<double> Numbers(const std::vector<RadarReturn>& returns) {
  std::vector<double> numbers;
  for (const RadarReturn& entry : returns) numbers.push_back(entry.power);
  return numbers;
}

TEST(GateFieldOfView, KeepsWhatLiesWithinAllBoundsInOrder) {
  PreprocessingOptions options;
  options.min_range = 3.0;
  options.max_range = 50.0;
  options.min_azimuth = -60.0 * kDegree;
  options.max_azimuth = 30.0 * kDegree;
  options.min_elevation = -10.0 * kDegree;
  options.max_elevation = 20.0 * kDegree;
  const std::vector<RadarReturn> returns = {At(10, 0, 0, 1),
                                            At(2.9, 0, 0, 2),
                                            At(50.1, 0, 0, 3),
                                            At(10, -61, 0, 4),
                                            At(10, -59, 0, 5),
                                            At(10, 31, 0, 6),
                                            At(10, 0, -11, 7),
                                            At(10, 0, 21, 8),
                                            At(49, 29, 19, 9)};
  EXPECT_THAT(Numbers(GateFieldOfView(returns, options)), ElementsAre(1, 5, 9));
  EXPECT_FALSE(FieldOfView(options).Contains({kNan, 0.0, 0.0}));
}

// By the angles themselves, for narrow, wide and round limits, also with edges behind the radar.
TEST(FieldOfView, IsThatOfTheAngles) {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    PreprocessingOptions options;
    options.min_range = random.Uniform(0.0, 4.0);
    options.max_range = random.Uniform(5.0, 12.0);
    options.min_azimuth = i % 10 == 0 ? -kPi : random.Uniform(-kPi, 1.0);
    options.max_azimuth = i % 10 < 2 ? kPi : random.Uniform(options.min_azimuth + 0.1, kPi);
    options.min_elevation = random.Uniform(-0.5 * kPi, 0.0);
    options.max_elevation = random.Uniform(0.1, 0.5 * kPi);
    const FieldOfView field_of_view(options);
    for (int k = 0; k < 50; ++k) {
      Spherical s;
      s.range = random.Uniform(0.1, 15.0);
      s.azimuth = random.Uniform(-kPi, kPi);
      s.elevation = k == 0 ? 0.5 * kPi : random.Uniform(-0.5 * kPi, 0.5 * kPi);
      const bool expected = s.range >= options.min_range && s.range <= options.max_range &&
                            s.azimuth >= options.min_azimuth && s.azimuth <= options.max_azimuth &&
                            s.elevation >= options.min_elevation &&
                            s.elevation <= options.max_elevation;
      EXPECT_EQ(field_of_view.Contains(FromSpherical(s)), expected) << i << " " << k;
    }
  }
  EXPECT_TRUE(FieldOfView(PreprocessingOptions()).Contains({0.0, 0.0, 3.0}));
}

TEST(GateFieldOfView, LetsAllDirectionsPassByDefault) {
  const PreprocessingOptions options;
  const std::vector<RadarReturn> returns = {
      At(10, 180, 0, 1), At(10, -180, 0, 2), At(10, 0, 90, 3), At(10, 0, -90, 4)};
  EXPECT_EQ(GateFieldOfView(returns, options).size(), 4u);
}

TEST(FilterAzimuthBins, OffKeepsAll) {
  const PreprocessingOptions options;
  const std::vector<RadarReturn> returns = {At(10, 0.2, 0, 1), At(20, 0.2, 0, 2)};
  EXPECT_THAT(Numbers(FilterAzimuthBins(returns, options)), ElementsAre(1, 2));
}

TEST(FilterAzimuthBins, ExactJoinsOnlyEqualElevations) {
  PreprocessingOptions options;
  options.azimuth_bin = PreprocessingOptions::AzimuthBin::kExact;
  options.azimuth_bin_width = kDegree;
  const std::vector<RadarReturn> returns = {At(30, 5.2, 0.0, 1),    // behind number 3
                                            At(40, 5.4, 0.001, 2),  // another elevation
                                            At(10, 5.8, 0.0, 3),    //
                                            At(20, 6.2, 0.0, 4),    // the next bin
                                            At(15, 5.5, 0.0, 5),    // behind number 3
                                            At(10, 5.1, 0.0, 6)};   // as near, but later
  EXPECT_THAT(Numbers(FilterAzimuthBins(returns, options)), ElementsAre(2, 3, 4));
}

TEST(FilterAzimuthBins, ExactTakesMinusZeroForZero) {
  PreprocessingOptions options;
  options.azimuth_bin = PreprocessingOptions::AzimuthBin::kExact;
  std::vector<RadarReturn> returns = {At(10, 5.2, 0.0, 1), At(20, 5.2, 0.0, 2)};
  returns[1].position.z() = -0.0;
  EXPECT_THAT(Numbers(FilterAzimuthBins(returns, options)), ElementsAre(1));
}

// Two returns on each of a thousand rays, stored as scans are: the farther ones go.
TEST(FilterAzimuthBins, ExactJoinsReturnsOfOneRayInSinglePrecision) {
  PreprocessingOptions options;
  options.azimuth_bin = PreprocessingOptions::AzimuthBin::kExact;
  options.azimuth_bin_width = kDegree;
  Random random(5);
  std::vector<RadarReturn> returns;
  for (int i = 0; i < 1000; ++i) {
    const double azimuth = 0.2 * (i % 500) - 49.95;  // no bin's edge
    const double elevation = random.Uniform(-20.0, 20.0);
    returns.push_back(At(random.Uniform(5.0, 30.0), azimuth, elevation, 1));
    returns.push_back(At(random.Uniform(40.0, 90.0), azimuth, elevation, 2));
  }
  for (RadarReturn& entry : returns) entry.position = entry.position.cast<float>().cast<double>();
  const std::vector<double> kept = Numbers(FilterAzimuthBins(returns, options));
  EXPECT_EQ(std::count(kept.begin(), kept.end(), 2.0), 0);
  EXPECT_GE(kept.size(), 998u) << "other elevations stay";
}

TEST(FilterAzimuthBins, QuantisedJoinsElevationBins) {
  PreprocessingOptions options;
  options.azimuth_bin = PreprocessingOptions::AzimuthBin::kQuantised;
  options.azimuth_bin_width = kDegree;
  options.elevation_bin_width = 2.0 * kDegree;
  const std::vector<RadarReturn> returns = {At(30, 5.2, 0.1, 1),   // behind number 2
                                            At(10, 5.8, 1.9, 2),   // elevation bin [0, 2)
                                            At(40, 5.5, 2.1, 3),   // the next one
                                            At(50, 5.5, -0.1, 4),  // the one below
                                            At(60, 4.9, 1.0, 5)};  // another azimuth
  EXPECT_THAT(Numbers(FilterAzimuthBins(returns, options)), ElementsAre(2, 3, 4, 5));
}

// The bins of the paper are 0 to B - 1: azimuth +pi belongs to the last, -pi to the first.
TEST(FilterAzimuthBins, HalfATurnBelongsToTheLastBin) {
  PreprocessingOptions options;
  options.azimuth_bin = PreprocessingOptions::AzimuthBin::kQuantised;
  options.azimuth_bin_width = kDegree;
  std::vector<RadarReturn> returns = {
      At(10, 179.5, 0.5, 1), At(20, 180, 0.5, 2), At(30, -179.5, 0.5, 3)};
  returns[1].position.y() = 0.0;  // exactly behind: atan2(+0, -x) = +pi
  EXPECT_THAT(Numbers(FilterAzimuthBins(returns, options)), ElementsAre(1, 3));
}

// Against the definition, bin by bin, on a random cloud.
TEST(FilterAzimuthBins, AgreesWithTheDefinitionOnARandomCloud) {
  PreprocessingOptions options;
  options.azimuth_bin = PreprocessingOptions::AzimuthBin::kQuantised;
  options.azimuth_bin_width = 3.0 * kDegree;
  options.elevation_bin_width = 5.0 * kDegree;
  Random random(3);
  std::vector<RadarReturn> returns;
  for (int i = 0; i < 800; ++i) {
    returns.push_back(At(
        random.Uniform(2.0, 90.0), random.Uniform(-180.0, 180.0), random.Uniform(-20.0, 20.0), i));
  }
  const auto bin = [&](const RadarReturn& entry) {
    const Spherical s = ToSpherical(entry.position);
    return std::pair(std::floor((s.azimuth / kDegree + 180.0) / 3.0),
                     std::floor((s.elevation / kDegree + 90.0) / 5.0));
  };
  std::vector<double> expected;
  for (const RadarReturn& entry : returns) {
    bool is_nearest = true;
    for (const RadarReturn& other : returns) {
      is_nearest = is_nearest &&
                   !(bin(other) == bin(entry) && other.position.norm() < entry.position.norm());
    }
    if (is_nearest) expected.push_back(entry.power);
  }
  ASSERT_LT(expected.size(), 700u);
  EXPECT_EQ(Numbers(FilterAzimuthBins(returns, options)), expected);
}

RadarScan MixedScan() {
  RadarScan scan;
  scan.has_doppler = true;
  scan.returns = {At(10, 5.2, 0.5, 1),
                  At(20, 5.3, 0.5, 2),
                  At(200, 0, 0, 3),
                  At(10, 0.5, 0.5, 4),
                  At(30, 10, 0, 5),
                  At(10, 40, 0, 6)};
  scan.returns[3].position.x() = kNan;
  scan.returns[4].doppler = std::numeric_limits<double>::infinity();
  return scan;
}

TEST(Preprocess, CountsWhatItDrops) {
  PreprocessingOptions options;
  options.azimuth_bin = PreprocessingOptions::AzimuthBin::kQuantised;
  DropCounts counts;
  EXPECT_THAT(Numbers(Preprocess(MixedScan(), SensorOptions(), options, &counts)),
              ElementsAre(1, 6));
  EXPECT_EQ(counts.not_finite, 1);
  EXPECT_EQ(counts.no_doppler, 1);
  EXPECT_EQ(counts.out_of_range, 1);  // 200 m
  EXPECT_EQ(counts.out_of_view, 0);
  EXPECT_EQ(counts.behind_nearest, 1);
  EXPECT_EQ(counts.Sum(), 4);
  options.max_azimuth = 39.0 * kDegree;
  EXPECT_THAT(Numbers(Preprocess(MixedScan(), SensorOptions(), options, &counts)), ElementsAre(1));
  EXPECT_EQ(counts.out_of_view, 1);  // at 40 degrees; they are added up
  EXPECT_EQ(counts.Sum(), 9);
}

TEST(Preprocess, WithoutDopplerInTheScanNoneIsAskedFor) {
  RadarScan scan = MixedScan();
  scan.has_doppler = false;
  DropCounts counts;
  EXPECT_THAT(Numbers(Preprocess(scan, SensorOptions(), PreprocessingOptions(), &counts)),
              ElementsAre(1, 2, 5, 6));
  EXPECT_EQ(counts.no_doppler, 0);
}

// At 40 degrees, and calibrated to 44, number 6 falls out of a view of 42 degrees.
TEST(Preprocess, CorrectsBeforeItGates) {
  PreprocessingOptions options;
  options.max_azimuth = 42.0 * kDegree;
  SensorOptions sensor;
  EXPECT_THAT(Numbers(CorrectAndGate(MixedScan(), sensor, options, nullptr)), ElementsAre(1, 2, 6));
  sensor.azimuth_scale = 1.1;
  const auto kept = CorrectAndGate(MixedScan(), sensor, options, nullptr);
  EXPECT_THAT(Numbers(kept), ElementsAre(1, 2));
  EXPECT_NEAR(ToSpherical(kept[0].position).azimuth, 5.72 * kDegree, 1e-12);
}

TEST(Preprocess, TakesAnEmptyScan) {
  DropCounts counts;
  PreprocessingOptions options;
  options.azimuth_bin = PreprocessingOptions::AzimuthBin::kExact;
  EXPECT_TRUE(Preprocess(RadarScan(), SensorOptions(), options, &counts).empty());
  EXPECT_EQ(counts.Sum(), 0);
}

TEST(PreprocessingOptions, NamesTheFieldThatIsOutOfRange) {
  std::string error;
  PreprocessingOptions options;
  EXPECT_TRUE(options.IsValid(&error)) << error;
  options.azimuth_bin_width = 0.0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("preprocessing.azimuth_bin_width"), std::string::npos);
  options = PreprocessingOptions();
  options.max_azimuth = -4.0;
  EXPECT_FALSE(options.IsValid(&error));
  options = PreprocessingOptions();
  options.min_range = 100.0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("preprocessing.min_range must be < preprocessing.max_range"),
            std::string::npos);
}

}  // namespace
}  // namespace radive
