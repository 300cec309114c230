// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <ceres/problem.h>
#include <gtest/gtest.h>

#include <memory>

#include "radive/factors/eikonal_factor.h"
#include "radive/factors/feature_prior_factor.h"
#include "radive/factors/sdf_fit_cost.h"
#include "radive/factors/sdf_fit_factor.h"
#include "radive/factors/sdf_joint_cost.h"
#include "tests/factor_test_utils.h"
#include "tests/neural_map/made_map.h"

namespace radive {
namespace {

using testing::ExpectJacobiansMatchDifferences;
using testing::ExpectJacobiansMatchNumeric;
using testing::RandomizedDecoder;

// Decoder that is u (c + f_0) for positive features.
SdfDecoder OffsetDecoder() {
  SdfDecoder decoder(4, 16, SdfDecoder::Activation::kRelu);
  decoder.parameters()[0] = 1.0;
  decoder.parameters()[16 * 8] = 1.0;
  return decoder;
}

std::vector<SdfNeighbor> SomeNeighbors() {
  return {{{0.2, -0.1, 0.3}, 0.5}, {{-0.4, 0.1, 0.2}, 0.3}, {{0.1, 0.5, -0.3}, 0.2}};
}

// Fields 0.5 m * (0.5 * 1 + 0.3 * 2 + 0.2 * 3) = 0.85 m.
TEST(SdfFitFactor, ResidualIsInStandardDeviations) {
  const SdfDecoder decoder = OffsetDecoder();
  const double f1[4] = {1, 0, 0, 0}, f2[4] = {2, 0, 0, 0}, f3[4] = {3, 0, 0, 0};
  const double* blocks[] = {f1, f2, f3, decoder.parameters().data()};
  double residual = 1.0;
  std::unique_ptr<ceres::CostFunction> cost(
      SdfFitFactor::Create(decoder, 0.5, SomeNeighbors(), 0.85, 0.1));
  ASSERT_TRUE(cost->Evaluate(blocks, &residual, nullptr));
  EXPECT_NEAR(residual, 0.0, 1e-12);
  cost.reset(SdfFitFactor::Create(decoder, 0.5, SomeNeighbors(), 0.55, 0.1));
  ASSERT_TRUE(cost->Evaluate(blocks, &residual, nullptr));
  EXPECT_NEAR(residual, 3.0, 1e-12) << "0.3 m above a label known to 0.1 m";
}

TEST(SdfFitFactor, AutodiffMatchesNumericForAllBlocks) {
  for (const int dim : {4, 8}) {
    const SdfDecoder decoder = RandomizedDecoder(dim, 16, SdfDecoder::Activation::kSoftsign, dim);
    std::vector<std::vector<double>> features;
    std::vector<const double*> blocks;
    for (int k = 0; k < 3; ++k) {
      features.emplace_back();
      for (int i = 0; i < dim; ++i) features.back().push_back(0.4 * i - 0.5 * k + 0.1);
    }
    for (const auto& feature : features) blocks.push_back(feature.data());
    blocks.push_back(decoder.parameters().data());
    const std::unique_ptr<ceres::CostFunction> cost(
        SdfFitFactor::Create(decoder, 0.5, SomeNeighbors(), 0.2, 0.1));
    ExpectJacobiansMatchDifferences(*cost, blocks);
    const std::unique_ptr<ceres::CostFunction> eikonal(
        EikonalFactor::Create(decoder,
                              0.5,
                              {{{0.2, 0.1, 0.3}, QuaternionFromRotationVector({0.1, 0.5, 0.2})},
                               {{-0.3, 0.1, 0.1}, QuaternionFromRotationVector({0.7, 0.1, 0.0})},
                               {{0.0, -0.4, 0.2}, Eigen::Quaterniond::Identity()}},
                              0.3,
                              0.25,
                              0.5));
    ExpectJacobiansMatchDifferences(*eikonal, blocks);
  }
}

// S = z of a point at the origin: gradient one. Twice as steep is one over.
TEST(EikonalFactor, ResidualIsInStandardDeviations) {
  SdfDecoder decoder(4, 16, SdfDecoder::Activation::kRelu);
  decoder.parameters()[6] = 1.0;   // z
  decoder.parameters()[7] = 10.0;  // far from the bend
  decoder.parameters()[16 * 8] = 1.0;
  const double feature[4] = {0, 0, 0, 0};
  const double* blocks[] = {feature, decoder.parameters().data()};
  const std::unique_ptr<ceres::CostFunction> cost(
      EikonalFactor::Create(decoder, 0.5, {EikonalNeighbor()}, 0.3, 0.25, 0.25));
  double residual = 1.0;
  ASSERT_TRUE(cost->Evaluate(blocks, &residual, nullptr));
  EXPECT_NEAR(residual, 0.0, 1e-9);
  decoder.parameters()[6] = 2.0;
  ASSERT_TRUE(cost->Evaluate(blocks, &residual, nullptr));
  EXPECT_NEAR(residual, 4.0, 1e-9);
}

TEST(FeaturePriorFactor, ResidualAndDerivatives) {
  const std::unique_ptr<ceres::CostFunction> cost(FeaturePriorFactor::Create({1, 2, 3, 4}, 0.5));
  const double feature[4] = {1, 2, 3, 5.5};
  const double* blocks[] = {feature};
  double residuals[4];
  ASSERT_TRUE(cost->Evaluate(blocks, residuals, nullptr));
  EXPECT_EQ(residuals[0], 0.0);
  EXPECT_EQ(residuals[3], 3.0);
  ExpectJacobiansMatchNumeric(*cost, {nullptr}, {feature});
}

// The product path against the public truth: residuals and all derivatives to 1e-9.
template <int kDim, int kHidden>
void ExpectCostMatchesFactors(SdfDecoder::Activation activation) {
  const SdfDecoder decoder = RandomizedDecoder(kDim, kHidden, activation, kDim * kHidden);
  const DecoderKernel<kDim, kHidden> kernel(decoder, 0.5);
  Random random(11);
  const int num_blocks = 5, num_samples = 4;
  std::vector<std::vector<double>> features(num_blocks);
  std::vector<const double*> blocks;
  for (auto& feature : features) {
    for (int i = 0; i < kDim; ++i) feature.push_back(random.Normal());
    blocks.push_back(feature.data());
  }
  // Sample s sees the features s, s + 1, s + 2 (modulo 5).
  SdfSampleGroup group;
  group.num_blocks = num_blocks;
  std::vector<std::vector<SdfNeighbor>> neighbors(num_samples);
  for (int s = 0; s < num_samples; ++s) {
    group.samples.push_back({static_cast<int>(group.terms.size()), 0.1 * s, 4.0 + s});
    for (int k = 0; k < 3; ++k) {
      const SdfNeighbor neighbor = {0.5 * testing::RandomNormal3(&random), 0.2 + 0.1 * k};
      neighbors[static_cast<std::size_t>(s)].push_back(neighbor);
      group.terms.push_back({(s + k) % num_blocks, neighbor.weight, neighbor.d});
    }
  }
  const SdfFitCost<kDim, kHidden> cost(kernel, group);
  std::vector<double> residuals(num_samples);
  std::vector<std::vector<double>> jacobians(num_blocks,
                                             std::vector<double>(num_samples * kDim, 7.0));
  std::vector<double*> jacobian_pointers;
  for (auto& jacobian : jacobians) jacobian_pointers.push_back(jacobian.data());
  ASSERT_TRUE(cost.Evaluate(blocks.data(), residuals.data(), jacobian_pointers.data()));
  std::vector<double> residuals_alone(num_samples);
  ASSERT_TRUE(cost.Evaluate(blocks.data(), residuals_alone.data(), nullptr));

  for (int s = 0; s < num_samples; ++s) {
    const std::size_t at = static_cast<std::size_t>(s);
    const std::unique_ptr<ceres::CostFunction> factor(
        SdfFitFactor::Create(decoder, 0.5, neighbors[at], 0.1 * s, 1.0 / (4.0 + s)));
    std::vector<const double*> factor_blocks;
    for (int k = 0; k < 3; ++k)
      factor_blocks.push_back(blocks[static_cast<std::size_t>((s + k) % num_blocks)]);
    factor_blocks.push_back(decoder.parameters().data());
    double residual = 0.0;
    std::vector<std::vector<double>> expected(3, std::vector<double>(kDim));
    double* expected_pointers[4] = {
        expected[0].data(), expected[1].data(), expected[2].data(), nullptr};
    ASSERT_TRUE(factor->Evaluate(factor_blocks.data(), &residual, expected_pointers));
    EXPECT_NEAR(residuals[at], residual, 1e-9);
    EXPECT_NEAR(residuals_alone[at], residual, 1e-9);
    for (int b = 0; b < num_blocks; ++b) {
      const int k = (b - s + num_blocks) % num_blocks;
      for (std::size_t i = 0; i < kDim; ++i) {
        const double entry = jacobians[static_cast<std::size_t>(b)][at * kDim + i];
        EXPECT_NEAR(entry, k < 3 ? expected[static_cast<std::size_t>(k)][i] : 0.0, 1e-9);
      }
    }
  }
}

TEST(SdfFitCost, AgreesWithTheFactors) {
  for (const auto activation : {SdfDecoder::Activation::kSoftsign, SdfDecoder::Activation::kRelu}) {
    ExpectCostMatchesFactors<4, 16>(activation);
    ExpectCostMatchesFactors<8, 32>(activation);
  }
}

// Three samples of two and three neighbours: residuals and all derivatives to 1e-9.
template <int kDim, int kHidden>
void ExpectJointCostMatchesFactors(SdfDecoder::Activation activation) {
  const SdfDecoder decoder = RandomizedDecoder(kDim, kHidden, activation, kDim + kHidden);
  ASSERT_EQ(decoder.parameters().size(),
            static_cast<std::size_t>(SdfJointCost<kDim, kHidden>::kNumParameters));
  Random random(12);
  std::vector<std::vector<double>> features(3);
  for (auto& feature : features) {
    for (int i = 0; i < kDim; ++i) feature.push_back(random.Normal());
  }
  const std::vector<std::vector<std::size_t>> seen = {{0, 1}, {2, 0, 1}, {1, 2}};
  SdfSampleGroup group;
  group.num_blocks = 3;
  std::vector<std::vector<SdfNeighbor>> neighbors(3);
  for (std::size_t s = 0; s < 3; ++s) {
    group.samples.push_back({static_cast<int>(group.terms.size()), 0.2, 4.0});
    for (const std::size_t b : seen[s]) {
      neighbors[s].push_back({0.5 * testing::RandomNormal3(&random), random.Uniform(0.2, 0.6)});
      group.terms.push_back(
          {static_cast<int>(b), neighbors[s].back().weight, neighbors[s].back().d});
    }
  }
  const SdfJointCost<kDim, kHidden> cost(activation, 0.5, group);
  const std::size_t num_parameters = decoder.parameters().size();
  std::vector<const double*> blocks;
  for (const auto& feature : features) blocks.push_back(feature.data());
  blocks.push_back(decoder.parameters().data());
  std::vector<std::vector<double>> jacobians(3, std::vector<double>(3 * kDim, 7.0));
  jacobians.emplace_back(3 * num_parameters, 7.0);
  std::vector<double*> pointers;
  for (auto& jacobian : jacobians) pointers.push_back(jacobian.data());
  double residuals[3], alone[3];
  ASSERT_TRUE(cost.Evaluate(blocks.data(), residuals, pointers.data()));
  ASSERT_TRUE(cost.Evaluate(blocks.data(), alone, nullptr));

  for (std::size_t s = 0; s < 3; ++s) {
    const std::unique_ptr<ceres::CostFunction> factor(
        SdfFitFactor::Create(decoder, 0.5, neighbors[s], 0.2, 0.25));
    std::vector<const double*> factor_blocks;
    std::vector<std::vector<double>> expected;
    for (const std::size_t b : seen[s]) {
      factor_blocks.push_back(features[b].data());
      expected.emplace_back(kDim);
    }
    factor_blocks.push_back(decoder.parameters().data());
    expected.emplace_back(num_parameters);
    std::vector<double*> expected_pointers;
    for (auto& jacobian : expected) expected_pointers.push_back(jacobian.data());
    double residual = 0.0;
    ASSERT_TRUE(factor->Evaluate(factor_blocks.data(), &residual, expected_pointers.data()));
    EXPECT_NEAR(residuals[s], residual, 1e-9);
    EXPECT_NEAR(alone[s], residual, 1e-9);
    for (std::size_t k = 0; k < seen[s].size(); ++k) {
      for (std::size_t i = 0; i < kDim; ++i) {
        EXPECT_NEAR(jacobians[seen[s][k]][s * kDim + i], expected[k][i], 1e-9);
      }
    }
    for (std::size_t i = 0; i < num_parameters; ++i) {
      EXPECT_NEAR(jacobians[3][s * num_parameters + i], expected.back()[i], 1e-9) << i;
    }
  }
}

TEST(SdfJointCost, AgreesWithTheFactors) {
  for (const auto activation : {SdfDecoder::Activation::kSoftsign, SdfDecoder::Activation::kRelu}) {
    ExpectJointCostMatchesFactors<4, 16>(activation);
    ExpectJointCostMatchesFactors<8, 32>(activation);
  }
}

}  // namespace
}  // namespace radive
