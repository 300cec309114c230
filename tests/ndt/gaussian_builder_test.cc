// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/gaussian_builder.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <string>

#include "radive/sensor/radar_noise_model.h"
#include "tests/synthetic_scene.h"

namespace radive {
namespace {

NdtOptions WithEpsilon(double epsilon) {
  NdtOptions options;
  options.epsilon = epsilon;
  return options;
}

// Two points in the voxel [0, 2) x [0, 2) x [0, 1): the covariance is a quarter of the outer
// product of their difference (0.8, 0.4, -0.2).
TEST(GaussiansOfVoxels, MeanCovarianceAndWeightByHand) {
  const std::vector<Gaussian3> gaussians =
      GaussiansOfVoxels({{0.2, 1.0, 0.7}, {1.0, 1.4, 0.5}}, {0.5, 1.0}, WithEpsilon(0.05));
  ASSERT_EQ(gaussians.size(), 1u);
  EXPECT_LT((gaussians[0].mean - Eigen::Vector3d(0.6, 1.2, 0.6)).norm(), 1e-15);
  Eigen::Matrix3d expected;
  expected << 0.16 + 0.05, 0.08, -0.04, 0.08, 0.04 + 0.05, -0.02, -0.04, -0.02, 0.01 + 0.05;
  EXPECT_LT((gaussians[0].covariance - expected).norm(), 1e-15);
  EXPECT_NEAR(gaussians[0].weight, 0.75, 1e-15);
  EXPECT_EQ(gaussians[0].count, 2);
}

// Voxels come in the order of their first points, and cells are floored, not truncated: -0.1 and
// 0.1 lie in different ones.
TEST(GaussiansOfVoxels, NegativeCoordinatesAndOrder) {
  const std::vector<Eigen::Vector3d> points = {{0.1, 0.1, 0.1},
                                               {-0.1, 0.1, 0.1},
                                               {0.1, -0.1, 0.1},
                                               {0.1, 0.1, -0.1},
                                               {1.9, 1.9, 0.9},
                                               {-1.9, 1.9, 0.9},
                                               {2.1, 0.1, 0.1}};
  const std::vector<Gaussian3> gaussians =
      GaussiansOfVoxels(points, std::vector<double>(points.size(), 1.0), WithEpsilon(0.1));
  ASSERT_EQ(gaussians.size(), 5u);
  EXPECT_LT((gaussians[0].mean - Eigen::Vector3d(1.0, 1.0, 0.5)).norm(), 1e-15);
  EXPECT_LT((gaussians[1].mean - Eigen::Vector3d(-1.0, 1.0, 0.5)).norm(), 1e-15);
  EXPECT_LT((gaussians[2].mean - points[2]).norm(), 1e-15);
  EXPECT_LT((gaussians[3].mean - points[3]).norm(), 1e-15);
  EXPECT_LT((gaussians[4].mean - points[6]).norm(), 1e-15);
  EXPECT_EQ(gaussians[0].count, 2);
  EXPECT_EQ(gaussians[2].count, 1);
}

TEST(GaussiansOfVoxels, SinglePointsHaveEpsilonOnly) {
  const std::vector<Gaussian3> gaussians =
      GaussiansOfVoxels({{5.0, 5.0, 5.0}}, {0.3}, WithEpsilon(0.05));
  ASSERT_EQ(gaussians.size(), 1u);
  EXPECT_EQ(gaussians[0].covariance, Eigen::Matrix3d(0.05 * Eigen::Matrix3d::Identity()));
  EXPECT_EQ(gaussians[0].weight, 0.3);
}

TEST(GaussiansOfVoxels, SparseVoxelsAreLeftOut) {
  NdtOptions options = WithEpsilon(0.05);
  options.min_points = 3;
  const std::vector<Eigen::Vector3d> points = {
      {0.1, 0.1, 0.1}, {10.1, 0.1, 0.1}, {0.2, 0.1, 0.1}, {10.2, 0.1, 0.1}, {10.3, 0.1, 0.1}};
  const std::vector<Gaussian3> gaussians =
      GaussiansOfVoxels(points, std::vector<double>(5, 1.0), options);
  ASSERT_EQ(gaussians.size(), 1u);
  EXPECT_NEAR(gaussians[0].mean.x(), 10.2, 1e-14);
  EXPECT_TRUE(GaussiansOfVoxels({}, {}, options).empty());
}

// Map coordinates of a million metres must not eat the covariance: points on a 1/64 m raster are
// exact there, so the result is that of the origin.
TEST(GaussiansOfVoxels, LargeOffsetsKeepTheirDigits) {
  Random random(1);
  const Eigen::Vector3d offset(1e6, -1e6, 1e4);
  std::vector<Eigen::Vector3d> near, far;
  for (int i = 0; i < 500; ++i) {
    Eigen::Vector3d p;
    for (int k = 0; k < 3; ++k) p[k] = std::floor(random.Uniform(0.0, 6.0) * 64.0) / 64.0;
    near.push_back(p);
    far.push_back(p + offset);
  }
  const std::vector<double> weights(500, 1.0);
  const std::vector<Gaussian3> expected = GaussiansOfVoxels(near, weights, WithEpsilon(0.01));
  const std::vector<Gaussian3> actual = GaussiansOfVoxels(far, weights, WithEpsilon(0.01));
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT((actual[i].mean - offset - expected[i].mean).norm(), 1e-9);
    EXPECT_LT((actual[i].covariance - expected[i].covariance).norm(), 1e-13);
    EXPECT_EQ(actual[i].count, expected[i].count);
  }
}

// Against the textbook formula, voxel by voxel.
TEST(GaussiansOfVoxels, EqualTheTwoPassFormula) {
  Random random(2);
  std::vector<Eigen::Vector3d> points;
  std::vector<double> weights;
  for (int i = 0; i < 2000; ++i) {
    points.push_back(3.0 * testing::RandomNormal3(&random));
    weights.push_back(random.Uniform(0.1, 1.0));
  }
  NdtOptions options = WithEpsilon(0.02);
  options.voxel_size = {1.0, 2.5, 0.7};
  std::size_t total = 0;
  for (const Gaussian3& gaussian : GaussiansOfVoxels(points, weights, options)) {
    const auto cell = [&](const Eigen::Vector3d& p) {
      return Eigen::Vector3d(
          std::floor(p.x() / 1.0), std::floor(p.y() / 2.5), std::floor(p.z() / 0.7));
    };
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weight = 0.0, n = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (cell(points[i]) != cell(gaussian.mean)) continue;
      sum += points[i];
      weight += weights[i];
      n += 1.0;
    }
    ASSERT_GT(n, 0.0);
    Eigen::Matrix3d covariance = 0.02 * Eigen::Matrix3d::Identity();
    for (const Eigen::Vector3d& p : points) {
      if (cell(p) == cell(gaussian.mean)) {
        covariance += (p - sum / n) * (p - sum / n).transpose() / n;
      }
    }
    EXPECT_LT((gaussian.mean - sum / n).norm(), 1e-13);
    EXPECT_LT((gaussian.covariance - covariance).norm(), 1e-13);
    EXPECT_NEAR(gaussian.weight, weight / n, 1e-14);
    EXPECT_EQ(gaussian.count, static_cast<int>(n));
    total += static_cast<std::size_t>(gaussian.count);
  }
  EXPECT_EQ(total, points.size());
}

// 40 m to the left at azimuth 90 degrees: range is along y, azimuth along x.
TEST(GaussiansOfReturns, HaveTheNoiseOfTheSensor) {
  SensorOptions sensor;
  sensor.sigma_range = 0.2;
  sensor.sigma_azimuth = 0.01;
  sensor.sigma_elevation = 0.03;
  std::vector<RadarReturn> returns(2);
  returns[0].position = {0.0, 40.0, 0.0};
  returns[1].position = {7.0, -4.0, 2.0};
  const std::vector<Gaussian3> gaussians =
      GaussiansOfReturns(returns, {1.0, 0.4}, sensor, WithEpsilon(0.05));
  ASSERT_EQ(gaussians.size(), 2u);
  const Eigen::Vector3d variances(0.16 + 0.05, 0.04 + 0.05, 1.44 + 0.05);
  EXPECT_LT((gaussians[0].covariance - Eigen::Matrix3d(variances.asDiagonal())).norm(), 1e-13);
  EXPECT_EQ(gaussians[0].mean, returns[0].position);
  EXPECT_EQ(gaussians[1].weight, 0.4);
  EXPECT_EQ(gaussians[1].count, 1);
  const Eigen::Matrix3d noise = gaussians[1].covariance - 0.05 * Eigen::Matrix3d::Identity();
  EXPECT_LT((noise - PositionCovariance(returns[1].position, sensor)).norm(), 1e-14);
}

TEST(NdtOptions, SaysWhatIsOutOfRange) {
  NdtOptions options;
  std::string error;
  EXPECT_TRUE(options.IsValid(&error)) << error;
  options.epsilon = 0.0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("ndt.epsilon must be > 0"), std::string::npos) << error;
  options = NdtOptions();
  options.voxel_size = {2.0, 2.0};
  EXPECT_FALSE(options.IsValid(&error));
}

}  // namespace
}  // namespace radive
