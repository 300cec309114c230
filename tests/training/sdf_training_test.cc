// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "radive/neural_map/sdf_query.h"
#include "radive/neural_map/surface_extractor.h"
#include "radive/training/sdf_mapper.h"
#include "tests/neural_map/made_map.h"

// Labels, samples and training, on scenes whose distances are known.

namespace radive {
namespace {

using testing::RandomizedDecoder;
using testing::ReturnsAt;

LabelScan ScanOf(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin) {
  return {origin, points, std::vector<double>(points.size(), 1.0)};
}

// The wall x = 5 m, seen from the origin.
std::vector<Eigen::Vector3d> Wall(double spacing) {
  std::vector<Eigen::Vector3d> points;
  for (double y = -3.0; y <= 3.0; y += spacing) {
    for (double z = -1.0; z <= 1.0; z += spacing) points.emplace_back(5.0, y, z);
  }
  return points;
}

double LabelAt(SdfTrainingOptions::Label kind, const Eigen::Vector3d& position) {
  SdfTrainingOptions options;
  options.label = kind;
  const LabelScan scan = ScanOf(Wall(0.2), Eigen::Vector3d::Zero());
  NeuralPoints map((NeuralMapOptions()));
  map.AddKeyframe(ReturnsAt(Wall(0.2)), 0);
  const SdfLabels labels({&scan}, map, options);
  return labels.At(position)->distance;
}

TEST(SdfLabels, DistancesToAWallByHand) {
  using Label = SdfTrainingOptions::Label;
  // In front of the wall (towards the radar) distances are positive.
  EXPECT_NEAR(LabelAt(Label::kPlane, {4.7, 0.07, 0.03}), 0.3, 1e-9);
  EXPECT_NEAR(LabelAt(Label::kPlane, {5.3, 0.07, 0.03}), -0.3, 1e-9);
  EXPECT_NEAR(LabelAt(Label::kPlane, {3.0, 0.07, 0.03}), 1.0, 1e-12) << "clamped";
  EXPECT_NEAR(LabelAt(Label::kSmooth, {4.7, 0.07, 0.03}), 0.3, 1e-9);
  EXPECT_NEAR(LabelAt(Label::kSmooth, {5.3, 0.07, 0.03}), -0.3, 1e-9);
  EXPECT_NEAR(LabelAt(Label::kUnsigned, {5.3, 0.0, 0.0}), 0.3, 1e-9);
  EXPECT_NEAR(LabelAt(Label::kRay, {4.7, 0.0, 0.0}), 0.3, 1e-9);
  EXPECT_NEAR(LabelAt(Label::kRay, {5.3, 0.0, 0.0}), -0.3, 1e-9);
}

// Of the wall's lower edge alone no plane can be told, unless the sensor is planar.
TEST(SdfLabels, ALineIsNoPlaneButForAPlanarSensor) {
  std::vector<Eigen::Vector3d> line;
  for (double y = -3.0; y <= 3.0; y += 0.2) line.emplace_back(5.0, y, 0.0);
  NeuralPoints map((NeuralMapOptions()));
  map.AddKeyframe(ReturnsAt(line), 0);
  const SdfTrainingOptions options;
  EXPECT_FALSE(SdfLabels({}, map, options).At({4.7, 0.1, 0.0}).has_value());
  const auto label = SdfLabels({}, map, options, true).At({4.7, 0.1, 0.4});
  ASSERT_TRUE(label.has_value());
  EXPECT_NEAR(label->distance, 0.3, 1e-9);
}

TEST(SdfLabels, NothingWithoutPoints) {
  SdfTrainingOptions options;
  NeuralPoints map((NeuralMapOptions()));
  EXPECT_FALSE(SdfLabels({}, map, options).At({0, 0, 0}).has_value());
  map.AddKeyframe(ReturnsAt({{1, 2, 3}, {1, 2, 4}}), 0);
  EXPECT_FALSE(SdfLabels({}, map, options).At({1, 2, 3}).has_value()) << "two points are no plane";
  options.label = SdfTrainingOptions::Label::kPlane;
  const SdfLabels empty({}, map, options);
  EXPECT_FALSE(empty.At({0, 0, 0}).has_value());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LabelScan scan = ScanOf({{1, 2, 3}, {1, 2, 4}, {nan, 2, 4}}, {0, 0, 0});
  const SdfLabels two({&scan}, map, options);
  EXPECT_EQ(two.num_points(), 2);
  EXPECT_FALSE(two.At({1, 2, 3}).has_value()) << "two points are no plane";
  EXPECT_FALSE(two.At({nan, 2, 3}).has_value());
  options.label = SdfTrainingOptions::Label::kUnsigned;
  EXPECT_NEAR(SdfLabels({&scan}, map, options).At({1, 2, 2})->distance, 1.0, 1e-12);
}

TEST(SdfSamples, LieInTheCubeAndDependOnTheirCellAlone) {
  NeuralPoints map((NeuralMapOptions()));
  const std::vector<int> seen = map.AddKeyframe(ReturnsAt(Wall(0.2)), 0);
  const LabelScan scan = ScanOf(Wall(0.2), Eigen::Vector3d::Zero());
  SdfTrainingOptions options;
  options.samples_per_point = 5;
  options.label = SdfTrainingOptions::Label::kPlane;
  const SdfLabels labels({&scan}, map, options);
  const std::vector<SdfSample> samples = DrawSamples(map, seen, labels, 3, options);
  ASSERT_EQ(samples.size(), 5 * seen.size());
  for (const SdfSample& sample : samples) {
    const Eigen::Vector3d offset = sample.position - map.point(sample.owner).position;
    EXPECT_LE(offset.lpNorm<Eigen::Infinity>(), 0.6);
    EXPECT_GT(sample.neighbors.count, 0);
  }
  const std::vector<SdfSample> one = DrawSamples(map, {seen[7]}, labels, 3, options);
  EXPECT_EQ(one[2].position, samples[7 * 5 + 2].position);
  EXPECT_NE(DrawSamples(map, {seen[7]}, labels, 4, options)[2].position, one[2].position);
}

// A scene of which the true distance is known.
struct Scene {
  std::vector<MapKeyframe> keyframes;
  std::vector<Eigen::Vector3d> near_surface;  // where the field is tested: within 0.3 m
  std::function<double(const Eigen::Vector3d&)> distance;
};

// Root mean square and largest error of the learned field.
std::pair<double, double> LearnedErrors(const Scene& scene, NeuralMapOptions map_options) {
  SdfTrainingOptions training;
  training.label = SdfTrainingOptions::Label::kPlane;
  training.label_points = 8;
  training.label_clamp = 2.0;
  training.samples_per_point = 32;
  training.sample_extent = 0.4;
  training.label_sigma = 0.02;
  training.solver.max_iterations = 20;
  SdfMapper mapper(map_options, training);
  for (int round = 0; round < 2; ++round) {
    for (const MapKeyframe& keyframe : scene.keyframes) mapper.AddKeyframe(keyframe);
  }
  double sum = 0.0, largest = 0.0;
  WithDecoderKernel(mapper.decoder(), map_options.resolution, [&](const auto& kernel) {
    for (const Eigen::Vector3d& position : scene.near_surface) {
      const SdfValue value = QuerySdf(mapper.map(), kernel, position);
      EXPECT_GT(value.num_neighbors, 0);
      const double error = value.value - scene.distance(position);
      sum += error * error;
      largest = std::max(largest, std::abs(error));
    }
  });
  const double rms = std::sqrt(sum / static_cast<double>(scene.near_surface.size()));
  std::cout << "rms " << rms << " m, largest " << largest << " m\n";
  return {rms, largest};
}

TEST(SdfTraining, LearnsAPlane) {
  Scene scene;
  scene.keyframes = {{{0, 0, 0}, ReturnsAt(Wall(0.1))}};
  scene.distance = [](const Eigen::Vector3d& p) { return 5.0 - p.x(); };
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const double x = random.Uniform(4.7, 5.3), y = random.Uniform(-2.0, 2.0);
    scene.near_surface.emplace_back(x, y, random.Uniform(-0.6, 0.6));
  }
  EXPECT_LT(LearnedErrors(scene, NeuralMapOptions()).first, 0.03);
}

// The outer edge of a house: the walls x = 5 (y > 0) and y = 0 (x > 5), seen from outside.
TEST(SdfTraining, LearnsACorner) {
  Scene scene;
  std::vector<Eigen::Vector3d> points;
  for (double z = -1.0; z <= 1.0; z += 0.05) {
    for (double s = 0.0; s <= 2.0; s += 0.05) {
      points.emplace_back(5.0, s, z);
      points.emplace_back(5.0 + s, 0.0, z);
    }
  }
  scene.keyframes = {{{0.0, -5.0, 0.0}, ReturnsAt(points)}};
  scene.distance = [](const Eigen::Vector3d& p) {
    const double x = p.x() - 5.0, y = p.y();
    if (x > 0.0 && y > 0.0) return -std::min(x, y);
    return std::hypot(std::min(x, 0.0), std::min(y, 0.0));
  };
  Random random(2);
  while (scene.near_surface.size() < 300) {
    const double x = random.Uniform(4.7, 6.0), y = random.Uniform(-0.3, 1.0);
    const Eigen::Vector3d p(x, y, random.Uniform(-0.6, 0.6));
    if (std::abs(scene.distance(p)) < 0.3) scene.near_surface.push_back(p);
  }
  NeuralMapOptions options;
  options.resolution = 0.2;
  options.softening = 0.05;
  EXPECT_LT(LearnedErrors(scene, options).first, 0.03);
}

// A round pole of 0.3 m radius, a quarter of it seen from each of four sides.
TEST(SdfTraining, LearnsAPole) {
  Scene scene;
  for (int side = 0; side < 4; ++side) {
    const double middle = 1.5707963 * side;
    std::vector<Eigen::Vector3d> points;
    for (double z = -1.0; z <= 1.0; z += 0.05) {
      for (double angle = middle - 0.8; angle <= middle + 0.8; angle += 0.15) {
        points.emplace_back(0.3 * std::cos(angle), 0.3 * std::sin(angle), z);
      }
    }
    scene.keyframes.push_back(
        {{8.0 * std::cos(middle), 8.0 * std::sin(middle), 0.0}, ReturnsAt(points)});
  }
  scene.distance = [](const Eigen::Vector3d& p) { return p.head<2>().norm() - 0.3; };
  Random random(3);
  while (scene.near_surface.size() < 300) {
    const double angle = random.Uniform(0.0, 6.28), r = random.Uniform(0.1, 0.6);
    scene.near_surface.emplace_back(
        r * std::cos(angle), r * std::sin(angle), random.Uniform(-0.6, 0.6));
  }
  NeuralMapOptions options;
  options.resolution = 0.2;
  options.softening = 0.05;
  EXPECT_LT(LearnedErrors(scene, options).first, 0.03);
}

// What training is for: held-out samples of a bent wall fit better afterwards than before.
TEST(SdfTraining, LowersTheHeldOutErrorAndLeavesOtherFeaturesAlone) {
  std::vector<Eigen::Vector3d> points;
  for (double y = -3.0; y <= 3.0; y += 0.1) {
    for (double z = -1.0; z <= 1.0; z += 0.1)
      points.emplace_back(5.0 + 0.3 * std::sin(2.0 * y), y, z);
  }
  NeuralPoints map((NeuralMapOptions()));
  const std::vector<int> seen = map.AddKeyframe(ReturnsAt(points), 0);
  const LabelScan scan = ScanOf(points, Eigen::Vector3d::Zero());
  SdfTrainingOptions options;
  options.samples_per_point = 8;
  const SdfLabels labels({&scan}, map, options);
  InitialisePoints(&map, seen, labels, 0);
  const SdfDecoder decoder = map.options().Decoder();
  const std::vector<SdfSample> held_out = DrawSamples(map, seen, labels, 99, options);
  const double before = LabelRms(held_out, map, decoder);
  const std::vector<double> first_feature(map.feature(0), map.feature(0) + 4);
  const std::vector<int> free(seen.begin() + 1, seen.end());
  const TrainingResult result =
      TrainFeatures(DrawSamples(map, seen, labels, 0, options), free, decoder, options, &map);
  EXPECT_TRUE(result.usable);
  EXPECT_EQ(result.num_free_points, static_cast<int>(free.size()));
  EXPECT_LT(LabelRms(held_out, map, decoder), 0.8 * before);
  EXPECT_TRUE(std::equal(first_feature.begin(), first_feature.end(), map.feature(0)));
}

// All solvers that options offer come to the same fit; eikonal factors are in the problem.
TEST(SdfTraining, SolversAgree) {
  const LabelScan scan = ScanOf(Wall(0.1), Eigen::Vector3d::Zero());
  std::vector<double> rms;
  for (const auto solver : {SolverOptions::LinearSolver::kCgnr,
                            SolverOptions::LinearSolver::kSparseNormalCholesky,
                            SolverOptions::LinearSolver::kIterativeSchur}) {
    for (const double eikonal_sigma : {0.0, 0.5}) {
      SdfTrainingOptions options;
      options.solver.linear_solver = solver;
      options.solver.max_iterations = 15;
      options.solver.max_linear_iterations = 200;
      options.eikonal_sigma = eikonal_sigma;
      NeuralPoints map((NeuralMapOptions()));
      const std::vector<int> seen = map.AddKeyframe(ReturnsAt(Wall(0.1)), 0);
      const SdfLabels labels({&scan}, map, options);
      InitialisePoints(&map, seen, labels, 0);
      const SdfDecoder decoder = map.options().Decoder();
      const std::vector<SdfSample> samples = DrawSamples(map, seen, labels, 0, options);
      EXPECT_TRUE(TrainFeatures(samples, seen, decoder, options, &map).usable);
      rms.push_back(LabelRms(samples, map, decoder));
    }
  }
  for (std::size_t i = 2; i < rms.size(); ++i) EXPECT_NEAR(rms[i], rms[i % 2], 2e-3);
}

TEST(SdfTraining, BadFeaturesAndEmptyScansNeverReachTheSolver) {
  NeuralPoints map((NeuralMapOptions()));
  const std::vector<int> seen = map.AddKeyframe(ReturnsAt(Wall(0.1)), 0);
  const LabelScan scan = ScanOf(Wall(0.1), Eigen::Vector3d::Zero());
  SdfTrainingOptions options;
  const SdfLabels labels({&scan}, map, options);
  const SdfDecoder decoder = map.options().Decoder();
  map.feature(3)[1] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<SdfSample> samples = DrawSamples(map, seen, labels, 0, options);
  const TrainingResult result = TrainFeatures(samples, seen, decoder, options, &map);
  EXPECT_TRUE(result.usable);
  EXPECT_GT(result.num_samples, 0);
  EXPECT_LT(result.num_samples, static_cast<int>(samples.size()));
  for (int k = 0; k < map.size(); ++k) {
    EXPECT_EQ(k == 3, std::isnan(map.feature(k)[1])) << k;
  }
  EXPECT_EQ(TrainFeatures({}, seen, decoder, options, &map).num_samples, 0);
  EXPECT_EQ(TrainFeatures(samples, {}, decoder, options, &map).num_samples, 0);

  SdfMapper mapper((NeuralMapOptions()), options);
  EXPECT_EQ(mapper.AddKeyframe({}).num_samples, 0);
  MapReturn entry;
  entry.position.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(mapper.AddKeyframe({{0, 0, 0}, {entry}}).num_samples, 0);
  EXPECT_EQ(mapper.MedianNeighbors(), 0.0);
}

TEST(SdfTraining, JointTrainingLearnsADecoderFromNothing) {
  NeuralMapOptions map_options;
  SdfTrainingOptions options;
  options.joint_keyframes = 2;
  options.samples_per_point = 6;
  SdfMapper mapper(map_options, options);
  mapper.AddKeyframe({{0, 0, 0}, ReturnsAt(Wall(0.1))});
  mapper.AddKeyframe({{0, 0, 0}, ReturnsAt(Wall(0.1))});
  EXPECT_LT(LabelRms(mapper.HeldOutSamples(options), mapper.map(), mapper.decoder()), 0.05);
  const std::vector<double> frozen = mapper.decoder().parameters();
  mapper.AddKeyframe({{0, 0, 0}, ReturnsAt(Wall(0.1))});
  EXPECT_EQ(mapper.decoder().parameters(), frozen);
}

// One step of training by either derivatives, with the decoder frozen and free, with some points
// held: the same features, and the same decoder.
TEST(SdfTraining, DerivativesAgree) {
  const LabelScan scan = ScanOf(Wall(0.25), Eigen::Vector3d::Zero());
  for (const bool is_decoder_free : {false, true}) {
    std::vector<std::vector<double>> results;
    for (const auto derivatives :
         {SdfTrainingOptions::Derivatives::kAnalytic, SdfTrainingOptions::Derivatives::kAutodiff}) {
      SdfTrainingOptions options;
      options.derivatives = derivatives;
      options.solver.max_iterations = 1;
      NeuralPoints map((NeuralMapOptions()));
      const std::vector<int> seen = map.AddKeyframe(ReturnsAt(Wall(0.25)), 0);
      const SdfLabels labels({&scan}, map, options);
      InitialisePoints(&map, seen, labels, 0);
      SdfDecoder decoder = map.options().Decoder();
      const std::vector<SdfSample> samples = DrawSamples(map, seen, labels, 0, options);
      const std::vector<int> free(seen.begin() + 5, seen.end());
      const TrainingResult result = is_decoder_free
                                        ? TrainDecoder(samples, free, options, &map, &decoder)
                                        : TrainFeatures(samples, free, decoder, options, &map);
      EXPECT_TRUE(result.usable);
      EXPECT_EQ(result.num_free_points, static_cast<int>(free.size()));
      std::vector<double> numbers = decoder.parameters();
      EXPECT_EQ(numbers != map.options().Decoder().parameters(), is_decoder_free);
      for (int k = 0; k < map.size(); ++k) {
        numbers.insert(numbers.end(), map.feature(k), map.feature(k) + 4);
      }
      results.push_back(numbers);
    }
    ASSERT_EQ(results[0].size(), results[1].size());
    for (std::size_t i = 0; i < results[0].size(); ++i) {
      EXPECT_NEAR(results[0][i], results[1][i], 1e-9);
    }
  }
}

// A wall in every scan, a ghost in one: the wall is kept, the ghost is not, although |S| is small
// at the ghost as well: once its trial is over.
TEST(SdfTraining, ALoneGhostIsNotKept) {
  SdfMapper mapper((NeuralMapOptions()), SdfTrainingOptions());
  for (int k = 0; k < 1 + 1 + SurfaceOptions().trial_keyframes; ++k) {
    std::vector<Eigen::Vector3d> points = Wall(0.2);
    if (k == 1) points.emplace_back(8.0, 1.0, 0.5);
    mapper.AddKeyframe({{0, 0, 0}, ReturnsAt(points)});
  }
  const std::vector<SurfacePoint> surface =
      ExtractSurface(mapper.map(), mapper.decoder(), SurfaceOptions());
  int num_wall = 0;
  for (const SurfacePoint& point : surface) {
    EXPECT_LT(point.position.x(), 7.0) << "the ghost";
    if (point.position.x() < 6.0) ++num_wall;
    EXPECT_GT(-point.normal.x(), 0.9) << "to the radar";
  }
  EXPECT_GT(num_wall, static_cast<int>(0.9 * mapper.map().size()));
}

// A lap driven again and again (500 keyframes of 40 a lap) ends with the points of the first lap.
TEST(SdfTraining, MemoryIsBounded) {
  NeuralMapOptions options;
  options.max_distance = 20.0;
  SdfMapper mapper(options, SdfTrainingOptions());
  Random random(4);
  int after_first_lap = 0;
  for (int k = 0; k < 500; ++k) {
    const double angle = 2.0 * 3.14159265 * k / 40.0;
    const Eigen::Vector3d radar(20.0 * std::cos(angle), 20.0 * std::sin(angle), 0.0);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 30; ++i) {
      const double at = angle + random.Uniform(0.0, 0.5), r = 26.0 + 0.1 * random.Normal();
      points.emplace_back(r * std::cos(at), r * std::sin(at), random.Uniform(0.0, 2.0));
    }
    points.push_back(radar + 15.0 * testing::RandomUnit3(&random));  // clutter
    mapper.AddKeyframe({radar, ReturnsAt(points)});
    if (k == 40) after_first_lap = mapper.map().size();
  }
  EXPECT_GT(after_first_lap, 100);
  EXPECT_LT(mapper.map().size(), 1.2 * after_first_lap);
}

}  // namespace
}  // namespace radive
