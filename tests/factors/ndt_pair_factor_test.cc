// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/factors/ndt_pair_factor.h"

#include <ceres/problem.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "radive/geometry/pose_manifold.h"
#include "radive/util/angle_units.h"
#include "tests/factor_test_utils.h"
#include "tests/synthetic_scene.h"

namespace radive {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

// The cost of one pair as the paper prints it, without anything of the factor.
double PaperCost(const Gaussian3& a, const Gaussian3& b, NdtNormalisation norm, const Rigid3& T) {
  const Eigen::Matrix3d R = T.RotationMatrix();
  const Eigen::Vector3d delta = R * a.mean + T.translation - b.mean;
  const Eigen::Matrix3d sigma = R * a.covariance * R.transpose() + b.covariance;
  const double k = norm == NdtNormalisation::kPaper
                       ? 1.0 / std::sqrt(std::pow(2.0 * kPi, 3.0) * sigma.determinant())
                       : 1.0;
  return a.weight * (1.0 - k * std::exp(-0.5 * delta.dot(sigma.inverse() * delta)));
}

// Turned by exp(dr) from the left, moved by dt.
Rigid3 Perturbed(const Rigid3& T, const Vector6d& delta) {
  return {QuaternionFromRotationVector(delta.head<3>()) * T.rotation,
          T.translation + delta.tail<3>()};
}

// Fourth-order central differences.
Vector6d PaperGradient(const Gaussian3& a,
                       const Gaussian3& b,
                       NdtNormalisation norm,
                       const Rigid3& T) {
  constexpr double h = 1e-4;
  Vector6d gradient;
  for (int i = 0; i < 6; ++i) {
    const auto cost = [&](double step) {
      return PaperCost(a, b, norm, Perturbed(T, step * Vector6d::Unit(i)));
    };
    gradient[i] = (cost(-2.0 * h) - 8.0 * cost(-h) + 8.0 * cost(h) - cost(2.0 * h)) / (12.0 * h);
  }
  return gradient;
}

struct FactorValue {
  double cost = 0.0;
  Vector6d gradient = Vector6d::Zero();  // [rotation vector, translation]
};

// The factor in a problem with its loss, as a user of the public API has it.
FactorValue Evaluate(const Gaussian3& a,
                     const Gaussian3& b,
                     NdtNormalisation norm,
                     const Rigid3& T) {
  PoseBlock pose = ToPoseBlock(T);
  ceres::Problem problem;
  const double depth = a.weight * NdtPairFactor(a, b, norm).WellDepth();
  problem.AddParameterBlock(pose.data(), 7, new PoseManifold);
  problem.AddResidualBlock(NdtPairFactor::Create(a, b, norm), new NdtPairLoss(depth), pose.data());
  FactorValue value;
  std::vector<double> gradient;
  problem.Evaluate(ceres::Problem::EvaluateOptions(), &value.cost, nullptr, &gradient, nullptr);
  value.gradient = Eigen::Map<const Vector6d>(gradient.data());
  value.gradient.head<3>() *= 0.5;  // the manifold's tangent is half the rotation vector
  return value;
}

struct Case {
  Gaussian3 a, b;
  Rigid3 T;
};

// A pair that is about `sigmas` standard deviations apart at its pose.
Case RandomCase(double sigmas, Random* random) {
  Case c;
  c.T = testing::RandomRigid3(kPi, 20.0, random);
  c.a.mean = 5.0 * testing::RandomNormal3(random);
  c.a.covariance = testing::RandomCovariance(0.2, 1.5, random);
  c.a.weight = random->Uniform(0.1, 1.0);
  c.b.covariance = testing::RandomCovariance(0.2, 1.5, random);
  const Eigen::Matrix3d R = c.T.RotationMatrix();
  const Eigen::Matrix3d sigma = R * c.a.covariance * R.transpose() + c.b.covariance;
  c.b.mean = c.T * c.a.mean + sigmas * testing::RandomDraw(sigma, random);
  return c;
}

class NdtPairFactorOf : public ::testing::TestWithParam<NdtNormalisation> {};
INSTANTIATE_TEST_SUITE_P(Normalisations,
                         NdtPairFactorOf,
                         ::testing::Values(NdtNormalisation::kPaper, NdtNormalisation::kUnit),
                         [](const auto& norm) {
                           return norm.param == NdtNormalisation::kPaper ? "Paper" : "Unit";
                         });

TEST_P(NdtPairFactorOf, IsThePapersCostUpToAConstant) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Case c = RandomCase(1.0, &random);
    const double cost = Evaluate(c.a, c.b, GetParam(), c.T).cost;
    const double paper = PaperCost(c.a, c.b, GetParam(), c.T);
    const double scale = c.a.weight * NdtPairFactor(c.a, c.b, GetParam()).WellDepth();
    for (int j = 0; j < 10; ++j) {
      // Turned about the mean of a, which keeps the pair in reach of its Gaussian.
      Rigid3 T = c.T;
      T.rotation = QuaternionFromRotationVector(0.5 * testing::RandomNormal3(&random)) * T.rotation;
      T.translation =
          c.T * c.a.mean - T.rotation * c.a.mean + 0.3 * testing::RandomNormal3(&random);
      const double moved = Evaluate(c.a, c.b, GetParam(), T).cost;
      const double moved_paper = PaperCost(c.a, c.b, GetParam(), T);
      EXPECT_NEAR(moved - cost, moved_paper - paper, 1e-9 * scale);
    }
  }
}

TEST_P(NdtPairFactorOf, GradientIsThatOfThePapersCost) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const Case c = RandomCase(i % 3 == 0 ? 0.1 : 1.0, &random);
    const Vector6d expected = PaperGradient(c.a, c.b, GetParam(), c.T);
    const Vector6d actual = Evaluate(c.a, c.b, GetParam(), c.T).gradient;
    EXPECT_LE((actual - expected).norm(), 1e-7 * expected.norm() + 1e-11)
        << "factor " << actual.transpose() << "\npaper  " << expected.transpose();
  }
}

TEST_P(NdtPairFactorOf, AutodiffMatchesNumeric) {
  Random random(3);
  const PoseManifold manifold;
  for (int i = 0; i < 30; ++i) {
    Case c = RandomCase(1.0, &random);
    if (i == 0) c.T = Rigid3();
    if (i == 1) {
      c.T = {QuaternionFromRotationVector({1e-8, -1e-8, 1e-8}), {1e-8, 1e-8, -1e-8}};
    }
    if (i < 2) c.b.mean = c.a.mean + Eigen::Vector3d(0.2, -0.4, 0.1);
    const std::unique_ptr<ceres::CostFunction> cost(NdtPairFactor::Create(c.a, c.b, GetParam()));
    const PoseBlock pose = ToPoseBlock(c.T);
    testing::ExpectJacobiansMatchNumeric(*cost, {&manifold}, {pose.data()});
  }
}

// Single-point voxels have equal or isotropic covariances: |Sigma| is then at its lower bound, the
// argument of the logarithm is 2, and cost and derivatives must stay finite.
TEST_P(NdtPairFactorOf, EqualAndIsotropicCovariances) {
  Random random(4);
  const PoseManifold manifold;
  const Eigen::Matrix3d shape = testing::RandomCovariance(0.2, 1.0, &random);
  for (const bool isotropic : {true, false}) {
    Gaussian3 a, b;
    a.covariance = isotropic ? Eigen::Matrix3d(0.05 * Eigen::Matrix3d::Identity()) : shape;
    b.covariance = a.covariance;
    a.mean = {10.0, 2.0, 1.0};
    b.mean = {10.2, 1.9, 1.1};
    // A turn leaves isotropic covariances equal; numeric differences are unreliable at zeros.
    Rigid3 T;
    if (isotropic) T.rotation = QuaternionFromRotationVector({0.2, -0.1, 0.3});
    b.mean = T * b.mean;
    const PoseBlock pose = ToPoseBlock(T);
    const std::unique_ptr<ceres::CostFunction> cost(NdtPairFactor::Create(a, b, GetParam()));
    const double* blocks[] = {pose.data()};
    Eigen::Vector4d residuals;
    ASSERT_TRUE(cost->Evaluate(blocks, residuals.data(), nullptr));
    const double expected = GetParam() == NdtNormalisation::kPaper ? std::sqrt(std::log(2.0)) : 0.0;
    EXPECT_NEAR(residuals[3], expected, 1e-12);
    testing::ExpectJacobiansMatchNumeric(*cost, {&manifold}, {pose.data()}, 1e-6);
  }
}

// Radar at (1, 2, 3), turned 90 degrees to the left; a scan mean at (5, 0, 0) lies at (1, 7, 3).
TEST(NdtPairFactor, IsZeroWhereTheMeansMeet) {
  Gaussian3 a, b;
  a.mean = {5.0, 0.0, 0.0};
  b.mean = {1.0, 7.0, 3.0};
  const Rigid3 T{QuaternionFromRotationVector({0.0, 0.0, 0.5 * kPi}), {1.0, 2.0, 3.0}};
  const FactorValue value = Evaluate(a, b, NdtNormalisation::kUnit, T);
  EXPECT_NEAR(value.cost, 0.0, 1e-15);
  EXPECT_LT(value.gradient.norm(), 1e-14);
}

// Variances 0.04 + 0.05 = 0.3^2 along each axis.
TEST(NdtPairFactor, ResidualIsInStandardDeviations) {
  Gaussian3 a, b;
  a.covariance = 0.04 * Eigen::Matrix3d::Identity();
  b.covariance = 0.05 * Eigen::Matrix3d::Identity();
  a.mean = {10.3, 0.6, -0.9};
  b.mean = {10.0, 0.0, 0.0};
  const std::unique_ptr<ceres::CostFunction> cost(
      NdtPairFactor::Create(a, b, NdtNormalisation::kUnit));
  const PoseBlock pose = ToPoseBlock(Rigid3());
  const double* blocks[] = {pose.data()};
  Eigen::Vector4d residuals;
  ASSERT_TRUE(cost->Evaluate(blocks, residuals.data(), nullptr));
  EXPECT_LT((residuals - Eigen::Vector4d(1.0, 2.0, -3.0, 0.0)).norm(), 1e-12) << residuals;
  // 1/2 rho = 1 - exp(-14/2), times the weight.
  a.weight = 0.5;
  EXPECT_NEAR(
      Evaluate(a, b, NdtNormalisation::kUnit, Rigid3()).cost, 0.5 * (1.0 - std::exp(-7.0)), 1e-12);
}

// Sigma = [5 2; 2 2] in the plane: L = [sqrt5 0; 2/sqrt5 sqrt(6/5)] by hand. With the transposed
// factor the second residual would be another.
TEST(NdtPairFactor, WhitensFullCovariances) {
  Gaussian3 a, b;
  a.covariance << 4.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.5;
  b.covariance << 1.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.5;
  b.covariance += 1e-12 * Eigen::Matrix3d::Identity();
  a.mean = {5.0, 7.0, 1.0};
  b.mean = {0.0, 0.0, 0.0};
  const std::unique_ptr<ceres::CostFunction> cost(
      NdtPairFactor::Create(a, b, NdtNormalisation::kUnit));
  const PoseBlock pose = ToPoseBlock(Rigid3());
  const double* blocks[] = {pose.data()};
  Eigen::Vector4d residuals;
  ASSERT_TRUE(cost->Evaluate(blocks, residuals.data(), nullptr));
  EXPECT_NEAR(residuals[0], 5.0 / std::sqrt(5.0), 1e-9);
  EXPECT_NEAR(residuals[1], (7.0 - 2.0) / std::sqrt(6.0 / 5.0), 1e-9);
  EXPECT_NEAR(residuals[2], 1.0, 1e-9);
}

// Minkowski: the bound (twice c) never exceeds |R S_A R' + S_B|.
TEST(NdtPairFactor, BoundIsBelowTheDeterminantForAllRotations) {
  Random random(5);
  double smallest_ratio = 1e300;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Matrix3d a = testing::RandomCovariance(0.01, 1.0, &random);
    const Eigen::Matrix3d b = testing::RandomCovariance(0.01, 1.0, &random);
    const double bound = 2.0 * NdtPairFactor::DeterminantBound(a, b);
    smallest_ratio = std::min(smallest_ratio, (a + b).determinant() / bound);
  }
  EXPECT_GE(smallest_ratio, 1.0);
  EXPECT_LT(smallest_ratio, 1.1) << "the bound should be tight";
}

TEST(NdtPairLoss, DerivativesMatchNumeric) {
  const NdtPairLoss loss(3.0);
  constexpr double h = 1e-5;
  for (const double s : {0.1, 1.0, 5.0, 20.0}) {
    double rho[3], above[3], below[3];
    loss.Evaluate(s, rho);
    loss.Evaluate(s + h, above);
    loss.Evaluate(s - h, below);
    EXPECT_NEAR(rho[1], (above[0] - below[0]) / (2.0 * h), 1e-9);
    EXPECT_NEAR(rho[2], (above[1] - below[1]) / (2.0 * h), 1e-9);
  }
}

}  // namespace
}  // namespace radive
