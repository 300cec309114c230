// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/solver/marginal_covariance.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/manifold.h>
#include <ceres/product_manifold.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "radive/geometry/rigid3.h"

namespace radive {
namespace {

// r = (a - 1) / 0.5 and (b - a) / 2, so var(a) = 0.25 and var(b) = 0.25 + 4.
struct Chain {
  template <typename T>
  bool operator()(const T* a, const T* b, T* residual) const {
    residual[0] = (a[0] - 1.0) / 0.5;
    residual[1] = (b[0] - a[0]) / 2.0;
    return true;
  }
};

TEST(MarginalCovariance, MarginalisesTheOtherBlocks) {
  double a = 0.3, b = -2.0;
  ceres::Problem problem;
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<Chain, 2, 1, 1>(new Chain), nullptr, &a, &b);
  const auto covariance = MarginalCovariance(&problem, &b);
  ASSERT_TRUE(covariance);
  ASSERT_EQ(covariance->rows(), 1);
  EXPECT_NEAR((*covariance)(0, 0), 4.25, 1e-12);

  // With a known, only the second residual counts.
  problem.SetParameterBlockConstant(&a);
  const auto conditional = MarginalCovariance(&problem, &b);
  ASSERT_TRUE(conditional);
  EXPECT_NEAR((*conditional)(0, 0), 4.0, 1e-12);
}

TEST(MarginalCovariance, HasNoneForConstantOrUnknownBlocks) {
  double a = 0.0, b = 0.0, c = 0.0;
  ceres::Problem problem;
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<Chain, 2, 1, 1>(new Chain), nullptr, &a, &b);
  problem.SetParameterBlockConstant(&a);
  EXPECT_FALSE(MarginalCovariance(&problem, &a));
  EXPECT_FALSE(MarginalCovariance(&problem, &c));
}

struct FirstOnly {
  template <typename T>
  bool operator()(const T* x, T* residual) const {
    residual[0] = x[0] / 3.0;
    return true;
  }
};

TEST(MarginalCovariance, GivesUnobservedDirectionsZeroVariance) {
  std::array<double, 2> x = {1.0, 1.0};
  ceres::Problem problem;
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<FirstOnly, 1, 2>(new FirstOnly), nullptr, x.data());
  const auto covariance = MarginalCovariance(&problem, x.data());
  ASSERT_TRUE(covariance);
  EXPECT_NEAR((*covariance)(0, 0), 9.0, 1e-12);
  EXPECT_NEAR((*covariance)(1, 1), 0.0, 1e-12);
}

// Residuals: the rotation vector from the truth, in the world frame, per 0.1 rad; the translation
// per 0.5 m; and the sum of the first of both, so that cross terms do not vanish.
struct PoseError {
  Rigid3 truth;
  template <typename T>
  bool operator()(const T* block, T* residual) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q(block);
    const Eigen::Quaternion<T> delta = q * truth.rotation.conjugate().cast<T>();
    // Rotation vector to first order, which is all that the covariance reads.
    for (int i = 0; i < 3; ++i) residual[i] = 2.0 * delta.vec()[i] / 0.1;
    for (int i = 0; i < 3; ++i) residual[3 + i] = (block[4 + i] - truth.translation[i]) / 0.5;
    residual[6] = 0.1 * residual[0] + 0.5 * residual[3];
    return true;
  }
};

TEST(MarginalCovariance, OfAPoseIsInRotationVectorsAfterConversion) {
  const Rigid3 truth(QuaternionFromRotationVector({0.4, -0.7, 1.1}), {5.0, 6.0, 7.0});
  PoseBlock block = ToPoseBlock(truth);
  ceres::Problem problem;
  problem.AddParameterBlock(
      block.data(),
      7,
      new ceres::ProductManifold<ceres::EigenQuaternionManifold, ceres::EuclideanManifold<3>>());
  problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PoseError, 7, 7>(new PoseError{truth}),
                           nullptr,
                           block.data());
  const auto tangent = MarginalCovariance(&problem, block.data());
  ASSERT_TRUE(tangent);
  ASSERT_EQ(tangent->rows(), 6);
  EXPECT_NEAR((*tangent)(1, 1), 0.05 * 0.05, 1e-12);  // half angles

  const Eigen::MatrixXd covariance = RotationVectorCovariance(*tangent);
  EXPECT_NEAR(covariance(1, 1), 0.01, 1e-12);
  EXPECT_NEAR(covariance(2, 2), 0.01, 1e-12);
  EXPECT_NEAR(covariance(4, 4), 0.25, 1e-12);
  // x of both: information [[100 + 1, 1], [1, 4 + 1]], determinant 504.
  EXPECT_NEAR(covariance(0, 0), 5.0 / 504.0, 1e-12);
  EXPECT_NEAR(covariance(0, 3), -1.0 / 504.0, 1e-12);
  EXPECT_NEAR(covariance(3, 0), -1.0 / 504.0, 1e-12);
  EXPECT_NEAR(covariance(3, 3), 101.0 / 504.0, 1e-12);
}

}  // namespace
}  // namespace radive
