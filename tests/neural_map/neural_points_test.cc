// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/neural_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "radive/neural_map/sdf_query.h"
#include "radive/neural_map/surface_extractor.h"
#include "tests/neural_map/made_map.h"

namespace radive {
namespace {

using testing::RandomizedDecoder;
using testing::RandomMap;
using testing::ReturnsAt;

MapReturn ReturnAt(double x, double weight) {
  MapReturn entry;
  entry.position = {x, 0.1, 0.1};
  entry.weight = weight;
  entry.covariance = x * Eigen::Matrix3d::Identity();
  return entry;
}

TEST(NeuralPoints, OnePointACellWithMeanAndCertainty) {
  NeuralMapOptions options;   // cells of 0.5 m
  options.noise_scale = 1e9;  // weights as they are given
  NeuralPoints map(options);
  EXPECT_EQ(map.AddKeyframe({ReturnAt(0.1, 0.5), ReturnAt(0.4, 1.0), ReturnAt(0.6, 1.0)}, 0),
            (std::vector<int>{0, 1}));
  ASSERT_EQ(map.size(), 2);
  // (0.5 * 0.1 + 1 * 0.4) / 1.5; the largest weight of the keyframe counts once.
  EXPECT_NEAR(map.point(0).position.x(), 0.3, 1e-12);
  EXPECT_NEAR(map.point(0).covariance(1, 1), 0.3, 1e-12);
  EXPECT_NEAR(map.point(0).certainty, 1.0, 1e-12);
  EXPECT_EQ(map.AddKeyframe({ReturnAt(0.2, 0.25)}, 3), std::vector<int>{0});
  EXPECT_NEAR(map.point(0).certainty, 1.25, 1e-12);
  EXPECT_EQ(map.point(0).created, 0);
  EXPECT_EQ(map.point(0).last_update, 3);
  EXPECT_EQ(map.point(1).last_update, 0);

  NeuralMapOptions first;
  first.position = NeuralMapOptions::Position::kFirst;
  NeuralPoints unmoved(first);
  unmoved.AddKeyframe({ReturnAt(0.1, 0.5), ReturnAt(0.4, 1.0)}, 0);
  EXPECT_EQ(unmoved.point(0).position.x(), 0.1);
}

TEST(NeuralPoints, ReturnsThatAreNoNumbersOrWeighNothingAreLeftOut) {
  NeuralPoints map((NeuralMapOptions()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(
      map.AddKeyframe({ReturnAt(nan, 1.0), ReturnAt(1.0, 0.0), ReturnAt(1.0, nan)}, 0).empty());
  EXPECT_TRUE(map.AddKeyframe({}, 1).empty());
  EXPECT_EQ(map.size(), 0);
  EXPECT_EQ(map.Nearest({0, 0, 0}).count, 0);
  EXPECT_EQ(map.Nearest({nan, 0, 0}).count, 0);
}

TEST(NeuralPoints, NearestAgreesWithLookingAtAll) {
  NeuralMapOptions options;
  const NeuralPoints map = RandomMap(options, 400, 2.0, 7);
  Random random(8);
  for (int trial = 0; trial < 200; ++trial) {
    const double x = random.Uniform(-2.5, 2.5), y = random.Uniform(-2.5, 2.5);
    const Eigen::Vector3d position(x, y, random.Uniform(-2.5, 2.5));
    std::vector<std::pair<double, int>> all;
    for (int k = 0; k < map.size(); ++k) {
      const double d = (map.point(k).position - position).squaredNorm();
      if (d <= 1.0) all.emplace_back(d, k);
    }
    std::sort(all.begin(), all.end());
    const Neighbors found = map.Nearest(position);
    ASSERT_EQ(found.count, std::min<int>(6, static_cast<int>(all.size())));
    for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i) {
      EXPECT_EQ(found.index[i], all[i].second);
    }
  }
}

TEST(NeuralPoints, OldAndFarPointsAreForgottenWithTheirFeatures) {
  NeuralMapOptions options;
  options.max_age = 5;
  options.max_distance = 50.0;
  NeuralPoints map(options);
  map.AddKeyframe({ReturnAt(1.0, 1.0), ReturnAt(2.0, 1.0), ReturnAt(49.0, 1.0)}, 0);
  map.feature(1)[2] = 42.0;
  map.AddKeyframe({ReturnAt(2.0, 1.0), ReturnAt(49.0, 1.0)}, 4);
  map.Prune({-5.0, 0.0, 0.0}, 6);
  ASSERT_EQ(map.size(), 1);  // the first is too old, the last 54 m away
  EXPECT_EQ(map.point(0).position.x(), 2.0);
  EXPECT_EQ(map.feature(0)[2], 42.0);
  EXPECT_EQ(map.At({2.0, 0.1, 0.1}), 0);
  EXPECT_EQ(map.At({1.0, 0.1, 0.1}), -1);
}

// 100 laps about a block, 100 scans each, with noise and with ghosts that are never seen again.
TEST(NeuralPoints, LapsDoNotAddUp) {
  constexpr int kScansPerLap = 100, kLaps = 100;
  const NeuralMapOptions options;
  NeuralPoints map(options);
  Random random(3);
  int largest_of_first_lap = 0, largest = 0;
  for (int scan = 0; scan < kLaps * kScansPerLap; ++scan) {
    const double angle = 2.0 * M_PI * scan / kScansPerLap;
    const Eigen::Vector3d radar(40.0 * std::cos(angle), 40.0 * std::sin(angle), 0.0);
    std::vector<Eigen::Vector3d> positions;
    for (int i = 0; i < 60; ++i) {  // walls to both sides of the street
      const double at = angle + random.Uniform(-0.5, 0.5), radius = i % 2 == 0 ? 30.0 : 50.0;
      positions.push_back(Eigen::Vector3d(radius * std::cos(at), radius * std::sin(at), 1.0) +
                          0.2 * testing::RandomNormal3(&random));
    }
    for (int i = 0; i < 6; ++i) positions.push_back(radar + 10.0 * testing::RandomNormal3(&random));
    map.Prune(radar, scan);
    map.AddKeyframe(ReturnsAt(positions), scan);
    largest = std::max(largest, map.size());
    if (scan == kScansPerLap) largest_of_first_lap = largest;
  }
  EXPECT_GT(largest_of_first_lap, 500);
  EXPECT_LE(largest, 1.2 * largest_of_first_lap);
}

// Turned and moved as a whole, the map has the same field at the moved places.
TEST(NeuralPoints, FieldMovesWithTheMap) {
  NeuralMapOptions options;
  options.num_neighbors = 4;
  NeuralPoints map = RandomMap(options, 60, 1.2, 3);
  const SdfDecoder decoder = RandomizedDecoder(4, 16, SdfDecoder::Activation::kSoftsign, 4);
  const DecoderKernel<4, 16> kernel(decoder, options.resolution);
  const std::vector<Eigen::Vector3d> places = {
      {0.1, 0.2, -0.3}, {0.5, -0.4, 0.3}, {-0.6, 0.1, 0.6}};
  std::vector<SdfValue> before;
  for (const Eigen::Vector3d& place : places) before.push_back(QuerySdf(map, kernel, place));
  const Rigid3 T_new_old(QuaternionFromRotationVector({0.3, -0.8, 1.1}), {20.0, -7.0, 3.0});
  map.Transform(T_new_old);
  EXPECT_EQ(map.size(), RandomMap(options, 60, 1.2, 3).size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SdfValue after = QuerySdf(map, kernel, T_new_old * places[i]);
    ASSERT_EQ(after.num_neighbors, 4);
    EXPECT_NEAR(after.value, before[i].value, 1e-12);
    EXPECT_LT((after.gradient - T_new_old.rotation * before[i].gradient).norm(), 1e-11);
  }
}

TEST(SdfQuery, GradientAgreesWithDifferences) {
  const NeuralPoints map = RandomMap(NeuralMapOptions(), 80, 1.0, 5);
  const SdfDecoder decoder = RandomizedDecoder(4, 16, SdfDecoder::Activation::kSoftsign, 6);
  const DecoderKernel<4, 16> kernel(decoder, 0.5);
  const Eigen::Vector3d place(0.13, -0.21, 0.08);
  const SdfValue at = QuerySdf(map, kernel, place);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d shift = 1e-6 * Eigen::Vector3d::Unit(k);
    const double slope =
        (QuerySdf(map, kernel, place + shift).value - QuerySdf(map, kernel, place - shift).value) /
        2e-6;
    EXPECT_NEAR(at.gradient[k], slope, 1e-6);
  }
}

// Two points 0.4 m apart, h = 0.3 m: at the first, weights are 1/0.09 and 1/0.25.
TEST(SdfQuery, WeightsByHand) {
  NeuralMapOptions options;
  NeuralPoints map(options);
  map.AddKeyframe(ReturnsAt({{0.3, 0.1, 0.1}, {0.7, 0.1, 0.1}}), 0);
  // D = u c + u f_0: the feature is the distance in units.
  SdfDecoder decoder(4, 16, SdfDecoder::Activation::kRelu);
  decoder.parameters()[0] = 1.0;
  decoder.parameters()[16 * 8] = 1.0;
  map.feature(0)[0] = 1.0;
  map.feature(1)[0] = 2.0;
  const DecoderKernel<4, 16> kernel(decoder, options.resolution);
  const SdfValue value = QuerySdf(map, kernel, {0.3, 0.1, 0.1});
  EXPECT_EQ(value.num_neighbors, 2);
  EXPECT_NEAR(value.value, (0.5 / 0.09 + 1.0 / 0.25) / (1.0 / 0.09 + 1.0 / 0.25), 1e-12);
  EXPECT_EQ(QuerySdf(map, kernel, {9.0, 0.0, 0.0}).num_neighbors, 0);
  map.feature(1)[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(QuerySdf(map, kernel, {0.3, 0.1, 0.1}).num_neighbors, 0) << "not a number says nothing";
}

// Cells of 0.5 m: at 0.4 m a point counts exp(-0.16 / 0.5).
TEST(NeuralPoints, SupportByHand) {
  NeuralPoints map((NeuralMapOptions()));
  map.AddKeyframe(ReturnsAt({{0.3, 0.1, 0.1}, {0.7, 0.1, 0.1}}), 0);
  EXPECT_NEAR(map.Support({0.3, 0.1, 0.1}), 1.0 + std::exp(-0.32), 1e-12);
  map.AddKeyframe(ReturnsAt({{0.3, 0.1, 0.1}}), 1);
  EXPECT_NEAR(map.Support({0.3, 0.1, 0.1}), std::sqrt(2.0) + std::exp(-0.32), 1e-12);
  EXPECT_EQ(map.Support({9.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(map.Support({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}), 0.0);
}

// s = 0.3 m: a return whose covariance has the trace 0.27 m^2 counts 0.09 / 0.36 = 1/4, so that the
// mean of it and an exact one lies at a fifth of the way.
TEST(NeuralPoints, NoisyReturnsCountLess) {
  NeuralMapOptions options;
  options.noise_scale = 0.3;
  NeuralPoints map(options);
  std::vector<MapReturn> returns = ReturnsAt({{0.1, 0.1, 0.1}, {0.2, 0.1, 0.1}});
  returns[1].covariance = 0.09 * Eigen::Matrix3d::Identity();
  map.AddKeyframe(returns, 0, {0.1, 8.0, 0.1});
  ASSERT_EQ(map.size(), 1);
  EXPECT_NEAR(map.point(0).weight_sum, 1.25, 1e-12);
  EXPECT_NEAR(map.point(0).position.x(), 0.1 + 0.1 / 5.0, 1e-12);
  EXPECT_NEAR(map.point(0).certainty, 1.0, 1e-12);
  EXPECT_GT(map.point(0).to_radar.y(), 0.99) << "towards the radar";
}

// Each point says its own feature of the surface, whatever the distance: S at a point is its own,
// or without itself the mean of its two neighbours at the same distance.
TEST(SurfaceExtractor, LeavesThePointItselfOut) {
  NeuralMapOptions options;
  options.softening = 0.001;
  options.position = NeuralMapOptions::Position::kFirst;
  NeuralPoints map(options);
  map.AddKeyframe(ReturnsAt({{0.25, 0.2, 0.2}, {0.75, 0.2, 0.2}, {1.25, 0.2, 0.2}}), 0);
  SdfDecoder decoder(4, 16, SdfDecoder::Activation::kRelu);
  decoder.parameters()[0] = 1.0;       // of the first entry of the feature
  decoder.parameters()[16 * 8] = 1.0;  // S = 0.5 m times that entry
  map.feature(0)[0] = 1.0;
  map.feature(1)[0] = 10.0;
  map.feature(2)[0] = 3.0;
  // The point itself weighs 1e6, its neighbours 4 each.
  const double all = (1e6 * 5.0 + 4.0 * 0.5 + 4.0 * 1.5) / (1e6 + 8.0);
  EXPECT_NEAR(EvaluatePoints(map, decoder)[1].sdf, all, 1e-9);
  EXPECT_NEAR(EvaluatePoints(map, decoder, true)[1].sdf, 1.0, 1e-9);
  SurfaceOptions surface;
  surface.trial_keyframes = 0;
  surface.min_support = 0.0;
  surface.threshold = 1.1;
  surface.leave_out_self = true;
  EXPECT_EQ(ExtractSurface(map, decoder, surface).size(), 1u) << "the one between the others";
}

// A street of keyframes: points come, move, are forgotten; features of what is seen change.
TEST(SurfaceEvaluation, IsThatOfAllPoints) {
  NeuralMapOptions options;
  options.max_age = 3;
  options.max_distance = 12.0;
  NeuralPoints map(options);
  SdfDecoder decoder = RandomizedDecoder(4, 16, SdfDecoder::Activation::kSoftsign, 5);
  Random random(4);
  SurfaceEvaluation evaluation;
  for (int index = 0; index < 12; ++index) {
    const Eigen::Vector3d origin(1.5 * index, 0.0, 0.0);
    std::vector<Eigen::Vector3d> positions;
    for (int i = 0; i < 40; ++i) {
      positions.push_back(origin + Eigen::Vector3d(random.Uniform(-9.0, 9.0),
                                                   random.Uniform(-2.0, 2.0),
                                                   random.Uniform(-0.5, 0.5)));
    }
    map.Prune(origin, index);
    for (const int k : map.AddKeyframe(ReturnsAt(positions), index)) {
      map.feature(k)[0] = random.Normal();
    }
    if (index == 8) map.Transform({Eigen::Quaterniond::Identity(), {0.2, 0.0, 0.0}});
    if (index == 10) decoder.parameters()[0] += 0.1;
    const std::vector<SurfacePoint> expected = EvaluatePoints(map, decoder, true);
    const std::vector<SurfacePoint>& found = evaluation.Update(map, decoder, true);
    ASSERT_EQ(found.size(), expected.size()) << index;
    for (std::size_t i = 0; i < found.size(); ++i) {
      ASSERT_EQ(found[i].index, expected[i].index);
      ASSERT_EQ(found[i].position, expected[i].position);
      ASSERT_EQ(found[i].sdf, expected[i].sdf);
      ASSERT_EQ(found[i].normal, expected[i].normal);
      ASSERT_EQ(found[i].support, expected[i].support);
      ASSERT_EQ(found[i].age, expected[i].age);
    }
  }
}

// A decoder that is the height over a point; points of one wall at z = 0.2 m and a lone ghost.
TEST(SurfaceExtractor, ThresholdAndSupport) {
  NeuralMapOptions options;
  NeuralPoints map(options);
  std::vector<Eigen::Vector3d> positions = {{40.1, 0.2, 0.2}};
  for (int i = 0; i < 6; ++i) positions.emplace_back(0.25 + 0.5 * i, 0.2, 0.2);
  map.AddKeyframe(ReturnsAt(positions), 0);
  positions.erase(positions.begin());
  map.AddKeyframe(ReturnsAt(positions), 1);
  const SdfDecoder flat(4, 16, SdfDecoder::Activation::kRelu);  // S = 0 everywhere
  SurfaceOptions surface;
  surface.trial_keyframes = 0;
  surface.min_support = 0.1;
  std::vector<SurfacePoint> found = ExtractSurface(map, flat, surface);
  ASSERT_EQ(found.size(), 6u) << "the ghost has no neighbours";
  EXPECT_EQ(found[0].index, 1);
  surface.min_support = 0.0;
  EXPECT_EQ(ExtractSurface(map, flat, surface).size(), 7u);

  SdfDecoder offset = flat;
  offset.parameters().back() = 0.3;  // S = 0.15 m everywhere
  surface.threshold = 0.1;
  EXPECT_TRUE(ExtractSurface(map, offset, surface).empty());
  surface.threshold = 0.15001;
  EXPECT_EQ(ExtractSurface(map, offset, surface).size(), 7u);
  surface.threshold = 0.1;
  surface.trial_keyframes = 2;
  found = ExtractSurface(map, offset, surface);
  ASSERT_EQ(found.size(), 7u) << "all were first seen less than two keyframes ago";
  EXPECT_EQ(found[1].position, map.point(1).position) << "but not moved by what is not believed";
  surface.trial_keyframes = 1;
  EXPECT_TRUE(ExtractSurface(map, offset, surface).empty());

  surface.soft = true;
  surface.min_support = 2.0;
  found = ExtractSurface(map, offset, surface);
  ASSERT_EQ(found.size(), 6u);
  const double support = map.Support(map.point(1).position);
  EXPECT_NEAR(found[0].weight, std::exp(-0.5 * 1.5 * 1.5) * support / (support + 2.0), 1e-12);
  surface.criterion = SurfaceOptions::Criterion::kDensity;
  EXPECT_NEAR(ExtractSurface(map, offset, surface)[0].weight, support / (support + 2.0), 1e-12);
}

}  // namespace
}  // namespace radive
