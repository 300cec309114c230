// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/factors/condensed_ndt_cost.h"

#include <ceres/problem.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <memory>
#include <tuple>
#include <vector>

#include "radive/factors/ndt_pair_factor.h"
#include "radive/geometry/pose_manifold.h"
#include "radive/solver/solve.h"
#include "tests/synthetic_scene.h"
#include "tests/with_kernels.h"

namespace radive {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Vector7d = Eigen::Matrix<double, 7, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

struct Scene {
  std::vector<Gaussian3> scan, submap;
  std::vector<NdtPair> pairs;
  Rigid3 T_submap_radar;  // near which the scan fits
};

// A scan of half of the submap, at a random pose; every pair, or only those of a search. Some scan
// Gaussians are without pairs.
Scene RandomScene(int num_submap, bool all_pairs, Random* random) {
  Scene scene;
  scene.submap = testing::RandomGaussians(num_submap, {15.0, 15.0, 3.0}, random);
  for (Gaussian3& gaussian : scene.submap) gaussian.confidence = random->Uniform(0.2, 1.0);
  scene.T_submap_radar = testing::RandomRigid3(3.0, 30.0, random);
  for (std::size_t i = 0; i < scene.submap.size(); i += 2) {
    Gaussian3 gaussian = testing::Transformed(scene.T_submap_radar.Inverse(), scene.submap[i]);
    gaussian.mean += 0.1 * testing::RandomNormal3(random);
    gaussian.covariance = testing::RandomCovariance(0.2, 0.6, random);
    gaussian.weight = random->Uniform(0.3, 1.0);
    scene.scan.push_back(gaussian);
  }
  for (const NdtPair& pair : testing::AllPairs(scene.scan.size(), scene.submap.size())) {
    if (pair.scan % 7 == 3) continue;
    const Eigen::Vector3d delta =
        scene.T_submap_radar * scene.scan[static_cast<std::size_t>(pair.scan)].mean -
        scene.submap[static_cast<std::size_t>(pair.submap)].mean;
    if (all_pairs || delta.norm() < 5.0) scene.pairs.push_back(pair);
  }
  return scene;
}

Rigid3 Near(const Rigid3& T, Random* random) {
  const Rigid3 offset = testing::RandomRigid3(0.05, 0.8, random);
  return {offset.rotation * T.rotation, T.translation + offset.translation};
}

PoseBlock ShiftedBlock(const Rigid3& T, const Eigen::Vector3d& origin) {
  return ToPoseBlock({T.rotation, T.translation - origin});
}

struct BlockValue {
  Vector7d residuals;
  Eigen::Matrix<double, 7, 6> jacobian;  // [rotation vector, translation], translated by hand
};

BlockValue Evaluate(const CondensedNdtCost& cost, const PoseBlock& pose) {
  BlockValue value;
  Eigen::Matrix<double, 7, 7, Eigen::RowMajor> ambient;
  const double* blocks[] = {pose.data()};
  double* jacobians[] = {ambient.data()};
  EXPECT_TRUE(cost.Evaluate(blocks, value.residuals.data(), jacobians));
  Eigen::Matrix<double, 7, 6, Eigen::RowMajor> plus;
  EXPECT_TRUE(PoseManifold().PlusJacobian(pose.data(), plus.data()));
  value.jacobian = ambient * plus;
  value.jacobian.leftCols<3>() *= 0.5;  // the manifold's tangent is half the rotation vector
  return value;
}

// The sum of one block a pair, through Ceres.
struct SumValue {
  double cost = 0.0;
  Vector6d gradient = Vector6d::Zero();
};

SumValue SumOfFactors(const Scene& scene, NdtNormalisation norm, const Rigid3& T) {
  PoseBlock pose = ToPoseBlock(T);
  ceres::Problem problem;
  problem.AddParameterBlock(pose.data(), 7, new PoseManifold);
  for (const NdtPair& pair : scene.pairs) {
    const Gaussian3& a = scene.scan[static_cast<std::size_t>(pair.scan)];
    const Gaussian3& b = scene.submap[static_cast<std::size_t>(pair.submap)];
    const double depth = a.weight * b.confidence * NdtPairFactor(a, b, norm).WellDepth();
    problem.AddResidualBlock(
        NdtPairFactor::Create(a, b, norm), new NdtPairLoss(depth), pose.data());
  }
  SumValue value;
  std::vector<double> gradient;
  problem.Evaluate(ceres::Problem::EvaluateOptions(), &value.cost, nullptr, &gradient, nullptr);
  value.gradient = Eigen::Map<const Vector6d>(gradient.data());
  value.gradient.head<3>() *= 0.5;
  return value;
}

class CondensedNdtCostOf
    : public ::testing::TestWithParam<std::tuple<NdtNormalisation, NdtDerivatives>> {
 protected:
  NdtNormalisation norm() const { return std::get<0>(GetParam()); }
  NdtDerivatives derivatives() const { return std::get<1>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(
    All,
    CondensedNdtCostOf,
    ::testing::Combine(::testing::Values(NdtNormalisation::kPaper, NdtNormalisation::kUnit),
                       ::testing::Values(NdtDerivatives::kAnalytic, NdtDerivatives::kAutodiff)),
    [](const auto& instance) {
      const bool paper = std::get<0>(instance.param) == NdtNormalisation::kPaper;
      const bool analytic = std::get<1>(instance.param) == NdtDerivatives::kAnalytic;
      return std::string(paper ? "Paper" : "Unit") + (analytic ? "Analytic" : "Autodiff");
    });

TEST_P(CondensedNdtCostOf, EqualsTheSumOfPairFactors) {
  Random random(1);
  for (int i = 0; i < 12; ++i) {
    const Scene scene = RandomScene(60, /*all_pairs=*/i % 3 == 0, &random);
    const Eigen::Vector3d origin = scene.T_submap_radar.translation;
    const CondensedNdtCost cost(
        scene.scan, scene.submap, scene.pairs, origin, norm(), derivatives());
    for (int j = 0; j < 3; ++j) {
      const Rigid3 T = Near(scene.T_submap_radar, &random);
      const SumValue expected = SumOfFactors(scene, norm(), T);
      const NdtQuadratic actual = cost.Quadratic(ShiftedBlock(T, origin).data());
      EXPECT_NEAR(actual.cost, expected.cost, 1e-9 * expected.cost);
      EXPECT_LE((actual.gradient - expected.gradient).norm(), 1e-9 * expected.gradient.norm());
    }
  }
}

TEST_P(CondensedNdtCostOf, BlockHasCostGradientAndMatrixExactly) {
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    const Scene scene = RandomScene(40, /*all_pairs=*/false, &random);
    const Eigen::Vector3d origin = scene.T_submap_radar.translation;
    const CondensedNdtCost cost(
        scene.scan, scene.submap, scene.pairs, origin, norm(), derivatives());
    const PoseBlock pose = ShiftedBlock(Near(scene.T_submap_radar, &random), origin);
    const NdtQuadratic quadratic = cost.Quadratic(pose.data());
    const BlockValue block = Evaluate(cost, pose);
    const double total = quadratic.cost + cost.offset();
    EXPECT_NEAR(0.5 * block.residuals.squaredNorm(), total, 1e-12 * total);
    EXPECT_LE((block.jacobian.transpose() * block.residuals - quadratic.gradient).norm(),
              1e-9 * quadratic.gradient.norm());
    EXPECT_EQ(block.jacobian.row(6).norm(), 0.0);
    // Some way from the hessian to the curvature, but not below a tenth of the hessian.
    const Matrix6d matrix = block.jacobian.transpose() * block.jacobian;
    const Matrix6d way = quadratic.curvature - quadratic.hessian;
    const double part = (matrix - quadratic.hessian).cwiseProduct(way).sum() / way.squaredNorm();
    EXPECT_GE(part, -1e-6);
    EXPECT_LE(part, 1.0 + 1e-6);
    EXPECT_LE((matrix - quadratic.hessian - part * way).norm(), 1e-8 * quadratic.hessian.norm());
    const Eigen::SelfAdjointEigenSolver<Matrix6d> above(matrix - 0.1 * quadratic.hessian);
    EXPECT_GE(above.eigenvalues()[0], -1e-8 * above.eigenvalues()[5]);
    const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(quadratic.hessian);
    EXPECT_GE(eigen.eigenvalues()[0], -1e-12 * eigen.eigenvalues()[5]);
  }
}

// Where the scan fits the pairs hardly pull against each other: Newton's step.
TEST_P(CondensedNdtCostOf, MatrixIsTheCurvatureWhereTheScanFits) {
  Random random(12);
  Scene scene = RandomScene(40, /*all_pairs=*/false, &random);
  scene.pairs.clear();
  for (std::size_t i = 0; i < scene.scan.size(); ++i) {
    scene.scan[i].mean = scene.T_submap_radar.Inverse() * scene.submap[2 * i].mean;
    scene.pairs.push_back({static_cast<int>(i), static_cast<int>(2 * i)});
  }
  const Eigen::Vector3d origin = scene.T_submap_radar.translation;
  const CondensedNdtCost cost(scene.scan, scene.submap, scene.pairs, origin, norm(), derivatives());
  Rigid3 T = scene.T_submap_radar;
  T.translation.x() += 0.1;
  const PoseBlock pose = ShiftedBlock(T, origin);
  const NdtQuadratic quadratic = cost.Quadratic(pose.data());
  const BlockValue block = Evaluate(cost, pose);
  EXPECT_GT((quadratic.hessian - quadratic.curvature).norm(), 1e-3 * quadratic.hessian.norm());
  EXPECT_LE((block.jacobian.transpose() * block.jacobian - quadratic.curvature).norm(),
            1e-8 * quadratic.hessian.norm());
}

// A trial step of the solver asks for the residuals alone.
TEST_P(CondensedNdtCostOf, CostAloneIsThatOfTheFullEvaluation) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Scene scene = RandomScene(40, /*all_pairs=*/i % 2 == 0, &random);
    const Eigen::Vector3d origin = scene.T_submap_radar.translation;
    const CondensedNdtCost cost(
        scene.scan, scene.submap, scene.pairs, origin, norm(), derivatives());
    const PoseBlock pose = ShiftedBlock(Near(scene.T_submap_radar, &random), origin);
    const double* blocks[] = {pose.data()};
    Vector7d residuals;
    ASSERT_TRUE(cost.Evaluate(blocks, residuals.data(), nullptr));
    const double expected = Evaluate(cost, pose).residuals.squaredNorm();
    EXPECT_NEAR(residuals.squaredNorm(), expected, 1e-11 * expected);
  }
}

TEST_P(CondensedNdtCostOf, OriginShiftsTheTranslationOnly) {
  Random random(4);
  const Scene scene = RandomScene(40, /*all_pairs=*/false, &random);
  const Rigid3 T = Near(scene.T_submap_radar, &random);
  const CondensedNdtCost plain(
      scene.scan, scene.submap, scene.pairs, Eigen::Vector3d::Zero(), norm(), derivatives());
  const Eigen::Vector3d origin(100.0, -200.0, 5.0);
  const CondensedNdtCost shifted(
      scene.scan, scene.submap, scene.pairs, origin, norm(), derivatives());
  const NdtQuadratic expected = plain.Quadratic(ToPoseBlock(T).data());
  const NdtQuadratic actual = shifted.Quadratic(ShiftedBlock(T, origin).data());
  EXPECT_NEAR(actual.cost, expected.cost, 1e-11 * expected.cost);
  EXPECT_LE((actual.gradient - expected.gradient).norm(), 1e-10 * expected.gradient.norm());
  EXPECT_LE((actual.scatter - expected.scatter).norm(), 1e-10 * expected.scatter.norm());
}

// With all pairs out of reach there is neither gradient nor curvature, and the cost is the full
// depth; the block must still be one that a solver can use.
TEST_P(CondensedNdtCostOf, PairsOutOfReachCostTheirDepth) {
  Random random(5);
  const Scene scene = RandomScene(20, /*all_pairs=*/true, &random);
  const CondensedNdtCost cost(
      scene.scan, scene.submap, scene.pairs, Eigen::Vector3d::Zero(), norm(), derivatives());
  const Rigid3 far{scene.T_submap_radar.rotation, {500.0, 0.0, 0.0}};
  const PoseBlock pose = ToPoseBlock(far);
  const NdtQuadratic quadratic = cost.Quadratic(pose.data());
  EXPECT_NEAR(quadratic.cost, cost.offset(), 1e-12 * cost.offset());
  EXPECT_LT(quadratic.gradient.norm() + quadratic.hessian.norm(), 1e-12);
  const BlockValue block = Evaluate(cost, pose);
  EXPECT_TRUE(block.residuals.allFinite() && block.jacobian.allFinite());
  EXPECT_NEAR(0.5 * block.residuals.squaredNorm(), 2.0 * cost.offset(), 1e-12 * cost.offset());
}

// Two scan Gaussians with two pairs each: the scatter is made of their summed gradients.
TEST_P(CondensedNdtCostOf, ScatterIsOfTheGradientsOfScanGaussians) {
  Random random(6);
  Scene scene = RandomScene(4, /*all_pairs=*/true, &random);
  scene.submap.resize(2);
  scene.scan.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    scene.submap[i].mean =
        scene.T_submap_radar * scene.scan[i].mean + 0.2 * testing::RandomUnit3(&random);
  }
  scene.pairs = testing::AllPairs(2, 2);
  const PoseBlock pose = ToPoseBlock(scene.T_submap_radar);
  Matrix6d expected = Matrix6d::Zero();
  for (int i = 0; i < 2; ++i) {
    const std::vector<NdtPair> single = {{i, 0}, {i, 1}};
    const CondensedNdtCost one(
        scene.scan, scene.submap, single, Eigen::Vector3d::Zero(), norm(), derivatives());
    const Vector6d g = one.Quadratic(pose.data()).gradient;
    expected += g * g.transpose();
  }
  const CondensedNdtCost both(
      scene.scan, scene.submap, scene.pairs, Eigen::Vector3d::Zero(), norm(), derivatives());
  const Matrix6d actual = both.Quadratic(pose.data()).scatter;
  EXPECT_LE((actual - expected).norm(), 1e-9 * expected.norm());
}

// The curvature at the minimum of a translation, against differences of the gradient. (Rotations
// leave out how Sigma turns.)
TEST_P(CondensedNdtCostOf, CurvatureIsTheSlopeOfTheGradient) {
  Random random(9);
  const Scene scene = RandomScene(40, /*all_pairs=*/false, &random);
  const CondensedNdtCost cost(
      scene.scan, scene.submap, scene.pairs, Eigen::Vector3d::Zero(), norm(), derivatives());
  const Rigid3 T = Near(scene.T_submap_radar, &random);
  const NdtQuadratic quadratic = cost.Quadratic(ToPoseBlock(T).data());
  constexpr double h = 1e-5;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
    const Vector6d above =
        cost.Quadratic(ToPoseBlock({T.rotation, T.translation + step}).data()).gradient;
    const Vector6d below =
        cost.Quadratic(ToPoseBlock({T.rotation, T.translation - step}).data()).gradient;
    const Eigen::Vector3d slope = ((above - below) / (2.0 * h)).tail<3>();
    const Eigen::Vector3d curvature = quadratic.curvature.block<3, 1>(3, 3 + i);
    const Eigen::Matrix3d hessian = quadratic.hessian.bottomRightCorner<3, 3>();
    EXPECT_LE((curvature - slope).norm(), 1e-6 * hessian.norm());
  }
  EXPECT_GT((quadratic.hessian - quadratic.curvature).norm(), 0.1 * quadratic.hessian.norm());
  EXPECT_LT((quadratic.curvature - quadratic.curvature.transpose()).norm(),
            1e-12 * quadratic.curvature.norm());
}

class AnalyticAndAutodiff : public ::testing::TestWithParam<NdtNormalisation> {};
INSTANTIATE_TEST_SUITE_P(Normalisations,
                         AnalyticAndAutodiff,
                         ::testing::Values(NdtNormalisation::kPaper, NdtNormalisation::kUnit),
                         [](const auto& norm) {
                           return norm.param == NdtNormalisation::kPaper ? "Paper" : "Unit";
                         });

// Whatever the processor that the kernels are compiled for.
TEST_P(AnalyticAndAutodiff, AgreeInCostGradientAndScatter) {
  for (const Kernels* kernels : AvailableKernels()) {
    SCOPED_TRACE(kernels->name);
    const testing::WithKernels with_kernels(*kernels);
    Random random(7);
    for (int i = 0; i < 60; ++i) {
      const Scene scene = RandomScene(50, /*all_pairs=*/i % 3 == 0, &random);
      const Eigen::Vector3d origin = scene.T_submap_radar.translation;
      const PoseBlock pose = ShiftedBlock(Near(scene.T_submap_radar, &random), origin);
      const auto at = [&](NdtDerivatives derivatives) {
        return CondensedNdtCost(
                   scene.scan, scene.submap, scene.pairs, origin, GetParam(), derivatives)
            .Quadratic(pose.data());
      };
      const NdtQuadratic expected = at(NdtDerivatives::kAutodiff);
      const NdtQuadratic actual = at(NdtDerivatives::kAnalytic);
      EXPECT_NEAR(actual.cost, expected.cost, 1e-9 * expected.cost);
      EXPECT_LE((actual.gradient - expected.gradient).norm(), 1e-9 * expected.gradient.norm());
      EXPECT_LE((actual.scatter - expected.scatter).norm(), 1e-9 * expected.scatter.norm());
    }
  }
}

// Gaussians that are no distributions make pairs that count for nothing, beside others that do.
TEST_P(AnalyticAndAutodiff, PairsOfSingularGaussiansCountForNothing) {
  for (const Kernels* kernels : AvailableKernels()) {
    SCOPED_TRACE(kernels->name);
    const testing::WithKernels with_kernels(*kernels);
    Random random(10);
    Scene scene = RandomScene(6, /*all_pairs=*/true, &random);
    const PoseBlock pose = ToPoseBlock(scene.T_submap_radar);
    const auto quadratic = [&] {
      return CondensedNdtCost(scene.scan,
                              scene.submap,
                              scene.pairs,
                              Eigen::Vector3d::Zero(),
                              GetParam(),
                              NdtDerivatives::kAnalytic)
          .Quadratic(pose.data());
    };
    const NdtQuadratic expected = quadratic();
    Gaussian3 singular;
    singular.covariance.setZero();
    singular.mean = scene.scan.front().mean;
    scene.scan.push_back(singular);
    scene.submap.push_back(singular);
    scene.pairs.push_back(
        {static_cast<int>(scene.scan.size()) - 1, static_cast<int>(scene.submap.size()) - 1});
    const NdtQuadratic actual = quadratic();
    EXPECT_LE((actual.gradient - expected.gradient).norm(), 1e-12 * expected.gradient.norm());
    EXPECT_LE((actual.hessian - expected.hessian).norm(), 1e-12 * expected.hessian.norm());
  }
}

// Different matrices, one minimum.
TEST_P(AnalyticAndAutodiff, EndAtTheSameMinimum) {
  Random random(8);
  SolverOptions options;
  options.max_iterations = 300;
  options.function_tolerance = 1e-16;
  options.parameter_tolerance = 1e-10;
  for (int i = 0; i < 10; ++i) {
    const Scene scene = RandomScene(80, /*all_pairs=*/false, &random);
    const Eigen::Vector3d origin = scene.T_submap_radar.translation;
    const Rigid3 offset = testing::RandomRigid3(0.01, 0.15, &random);
    const PoseBlock start =
        ToPoseBlock({offset.rotation * scene.T_submap_radar.rotation, offset.translation});
    Rigid3 minima[2];
    for (const bool analytic : {false, true}) {
      PoseBlock pose = start;
      ceres::Problem problem;
      problem.AddParameterBlock(pose.data(), 7, new PoseManifold);
      problem.AddResidualBlock(
          new CondensedNdtCost(scene.scan,
                               scene.submap,
                               scene.pairs,
                               origin,
                               GetParam(),
                               analytic ? NdtDerivatives::kAnalytic : NdtDerivatives::kAutodiff),
          nullptr,
          pose.data());
      const SolveSummary summary = Solve(options, &problem);
      ASSERT_TRUE(summary.usable && summary.final_cost < summary.initial_cost) << summary.message;
      minima[analytic] = FromPoseBlock(pose);
    }
    EXPECT_LT((minima[0].translation - minima[1].translation).norm(), 1e-4);
    EXPECT_LT(RotationVector(minima[0].rotation * minima[1].rotation.conjugate()).norm(), 1e-5);
  }
}

}  // namespace
}  // namespace radive
