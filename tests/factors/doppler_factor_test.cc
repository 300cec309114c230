// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/factors/doppler_factor.h"

#include <gtest/gtest.h>

#include <memory>

#include "radive/factors/condensed_doppler_factor.h"
#include "radive/util/random.h"
#include "tests/factor_test_utils.h"

namespace radive {
namespace {

double Residual(const ceres::CostFunction& cost, const Eigen::Vector3d& v_radar) {
  const double* blocks[] = {v_radar.data()};
  double residual = 0.0;
  EXPECT_TRUE(cost.Evaluate(blocks, &residual, nullptr));
  return residual;
}

// Driving at +10 m/s along x, a static return straight ahead closes in: range rate -10 m/s.
TEST(DopplerFactor, IsZeroForStaticReturnAhead) {
  const std::unique_ptr<ceres::CostFunction> cost(
      DopplerFactor::Create(Eigen::Vector3d::UnitX(), -10.0, /*sigma=*/0.1));
  EXPECT_NEAR(Residual(*cost, {10.0, 0.0, 0.0}), 0.0, 1e-12);
}

// 3-4-5: at 10 m/s ahead and 5 m/s to the left, a return to the front left at (3, 4) closes in with
// 0.6 * 10 + 0.8 * 5 = 10 m/s.
TEST(DopplerFactor, IsZeroForStaticReturnToTheSide) {
  const std::unique_ptr<ceres::CostFunction> cost(
      DopplerFactor::Create({0.6, 0.8, 0.0}, -10.0, /*sigma=*/0.1));
  EXPECT_NEAR(Residual(*cost, {10.0, 5.0, 7.0}), 0.0, 1e-12);  // v_z does not matter in the plane
}

TEST(DopplerFactor, ResidualIsInStandardDeviations) {
  const std::unique_ptr<ceres::CostFunction> cost(
      DopplerFactor::Create(Eigen::Vector3d::UnitX(), -9.7, /*sigma=*/0.1));
  EXPECT_NEAR(Residual(*cost, {10.0, 0.0, 0.0}), 3.0, 1e-12);
}

// With a span of 4 m/s, -10 m/s is measured as -2: the residual is that to the nearest multiple.
TEST(DopplerFactor, WrapsToTheNearestMultipleOfTheSpan) {
  const std::unique_ptr<ceres::CostFunction> exact(
      DopplerFactor::Create(Eigen::Vector3d::UnitX(), -2.0, /*sigma=*/0.1, /*span=*/4.0));
  EXPECT_NEAR(Residual(*exact, {10.0, 0.0, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(Residual(*exact, {10.3, 0.0, 0.0}), 3.0, 1e-12);
  EXPECT_NEAR(Residual(*exact, {13.0, 0.0, 0.0}), -10.0, 1e-12);  // 3 is nearer to 4
  testing::ExpectJacobiansMatchNumeric(
      *exact, {nullptr}, {Eigen::Vector3d(10.3, 1.0, 0.0).eval().data()});
}

TEST(DopplerFactor, AutodiffMatchesNumeric) {
  const Eigen::Vector3d direction = Eigen::Vector3d(3.0, -1.0, 0.5).normalized();
  const std::unique_ptr<ceres::CostFunction> cost(DopplerFactor::Create(direction, 4.0, 0.1));
  for (const Eigen::Vector3d& v_radar : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(9, -2, 1)}) {
    testing::ExpectJacobiansMatchNumeric(*cost, {nullptr}, {v_radar.data()});
  }
}

// Cost, gradient and Gauss-Newton matrix of one cost function.
struct NormalEquations {
  double cost = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();

  void Add(const ceres::CostFunction& function, const Eigen::Vector3d& v_radar) {
    const double* blocks[] = {v_radar.data()};
    Eigen::VectorXd residuals(function.num_residuals());
    Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> jacobian(function.num_residuals(), 3);
    double* jacobians[] = {jacobian.data()};
    ASSERT_TRUE(function.Evaluate(blocks, residuals.data(), jacobians));
    cost += 0.5 * residuals.squaredNorm();
    gradient += jacobian.transpose() * residuals;
    matrix += jacobian.transpose() * jacobian;
  }
};

void ExpectCondensedEqualsSum(int num_returns, bool is_planar) {
  Random random(5);
  CondensedDopplerFactor::Sum sum;
  std::vector<std::unique_ptr<ceres::CostFunction>> factors;
  const Eigen::Vector3d truth(17.0, -2.0, 0.3);
  for (int i = 0; i < num_returns; ++i) {
    const Eigen::Vector3d direction =
        Eigen::Vector3d(2.0, random.Normal(), is_planar ? 0.0 : 0.2 * random.Normal()).normalized();
    const double v_doppler = -direction.dot(truth) + 0.1 * random.Normal();
    const double sigma = random.Uniform(0.05, 0.2);
    sum.Add(direction, v_doppler, sigma);
    factors.emplace_back(DopplerFactor::Create(direction, v_doppler, sigma));
  }
  const std::unique_ptr<ceres::CostFunction> condensed(CondensedDopplerFactor::Create(sum));
  for (const Eigen::Vector3d& v_radar :
       {truth, Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(9, 3, 1)}) {
    NormalEquations expected, actual;
    for (const auto& factor : factors) expected.Add(*factor, v_radar);
    actual.Add(*condensed, v_radar);
    // At the truth the cost is what is left of squares thirty thousand times as large.
    EXPECT_NEAR(actual.cost, expected.cost, 1e-13 * num_returns * 170.0 * 170.0);
    const double gradient_scale = expected.matrix.norm() * truth.norm();
    EXPECT_LE((actual.gradient - expected.gradient).norm(), 1e-12 * gradient_scale);
    EXPECT_LE((actual.matrix - expected.matrix).norm(), 1e-12 * expected.matrix.norm());
  }
}

TEST(CondensedDopplerFactor, EqualsTheSumOfDopplerFactors) {
  ExpectCondensedEqualsSum(500, /*is_planar=*/false);
}

TEST(CondensedDopplerFactor, EqualsTheSumWhereTheSumIsSingular) {
  ExpectCondensedEqualsSum(100, /*is_planar=*/true);
  ExpectCondensedEqualsSum(2, /*is_planar=*/false);
  ExpectCondensedEqualsSum(1, /*is_planar=*/true);
}

// Two returns, ahead and to the left, 3 and 4 standard deviations off: cost 1/2 (9 + 16).
TEST(CondensedDopplerFactor, CostIsInStandardDeviations) {
  CondensedDopplerFactor::Sum sum;
  sum.Add(Eigen::Vector3d::UnitX(), -9.7, 0.1);
  sum.Add(Eigen::Vector3d::UnitY(), -5.8, 0.2);
  const std::unique_ptr<ceres::CostFunction> cost(CondensedDopplerFactor::Create(sum));
  NormalEquations actual;
  actual.Add(*cost, {10.0, 5.0, 0.0});
  EXPECT_NEAR(actual.cost, 12.5, 1e-9);
  NormalEquations at_truth;
  at_truth.Add(*cost, {9.7, 5.8, 0.0});
  EXPECT_NEAR(at_truth.cost, 0.0, 1e-9);
}

TEST(CondensedDopplerFactor, AutodiffMatchesNumeric) {
  CondensedDopplerFactor::Sum sum;
  sum.Add(Eigen::Vector3d(3.0, -1.0, 0.5).normalized(), 4.0, 0.1);
  sum.Add(Eigen::Vector3d(2.0, 1.0, 0.1).normalized(), -3.0, 0.3);
  sum.Add(Eigen::Vector3d(1.0, 2.0, -0.4).normalized(), 1.0, 0.2);
  const std::unique_ptr<ceres::CostFunction> cost(CondensedDopplerFactor::Create(sum));
  for (const Eigen::Vector3d& v_radar : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(9, -2, 1)}) {
    testing::ExpectJacobiansMatchNumeric(*cost, {nullptr}, {v_radar.data()});
  }
}

}  // namespace
}  // namespace radive
