// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// What holds for every registration.method, and what tells them apart.

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <string>

#include "radive/registration/registration.h"
#include "tests/registration/street_registration.h"

namespace radive {
namespace {

using testing::Patient;
using testing::PointGaussians;
using testing::RotationError;

constexpr double kPointSigma = 0.02;  // noise of the points [m]

// Points on the floor, two side walls, an end wall and four pillars of a hall of 40 x 16 x 4 m.
std::vector<Eigen::Vector3d> HallPoints(int count, Random* random) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double x = random->Uniform(-20.0, 20.0), z = random->Uniform(0.0, 4.0);
    switch (i % 5) {
      case 0:
        points.emplace_back(x, random->Uniform(-8.0, 8.0), 0.0);
        break;
      case 1:
        points.emplace_back(x, -8.0, z);
        break;
      case 2:
        points.emplace_back(x, 8.0, z);
        break;
      case 3:
        points.emplace_back(20.0, random->Uniform(-8.0, 8.0), z);
        break;
      default: {
        const double angle = random->Uniform(0.0, 6.28);
        const double pillar = -12.0 + 8.0 * static_cast<double>(random->Index(4));
        points.emplace_back(pillar + std::cos(angle), -4.0 + std::sin(angle), z);
      }
    }
  }
  return points;
}

std::vector<Eigen::Vector3d> InFrame(const Rigid3& T_frame_world,
                                     std::vector<Eigen::Vector3d> points) {
  for (Eigen::Vector3d& p : points) p = T_frame_world * p;
  return points;
}

class EveryMethod : public ::testing::TestWithParam<RegistrationMethod> {
 protected:
  static RegistrationOptions Options(RegistrationMethod method) {
    RegistrationOptions options = Patient();
    options.method = method;
    options.icp_sigma = 0.2;
    return options;
  }

  static bool HasSurfaces() {
    return GetParam() == RegistrationMethod::kGicp || GetParam() == RegistrationMethod::kPlaneIcp ||
           GetParam() == RegistrationMethod::kDopplerIcp;
  }

  // Aligns `scan` (radar frame) with `submap` from T_prediction.
  RegistrationResult Align(const std::vector<Gaussian3>& scan,
                           const std::vector<Gaussian3>& submap,
                           const Rigid3& T_prediction) {
    const PairSearch search(submap);
    input_.scan = &scan;
    input_.search = &search;
    input_.T_prediction = T_prediction;
    input_.slack = 0.7;
    PairOptions pairs;
    pairs.d_max = 2.0;
    pairs.max_neighbors = 0;  // of points this dense the nearest ten lie on one side
    return Register(input_, pairs, Options(GetParam()));
  }

  RegistrationInput input_;
};
INSTANTIATE_TEST_SUITE_P(Methods,
                         EveryMethod,
                         ::testing::Values(RegistrationMethod::kNdt,
                                           RegistrationMethod::kFullNdt,
                                           RegistrationMethod::kGicp,
                                           RegistrationMethod::kPlaneIcp,
                                           RegistrationMethod::kIcp,
                                           RegistrationMethod::kDopplerIcp),
                         [](const auto& method) {
                           RegistrationOptions options;
                           options.method = method.param;
                           for (const OptionField& field : options.Fields()) {
                             if (field.name == "method") return field.ToString();
                           }
                           return std::string();
                         });

// Other points of the same surfaces, from starts beside the truth, in all six degrees of freedom.
TEST_P(EveryMethod, RecoversTheTruth) {
  Random random(1);
  const Rigid3 T_true{QuaternionFromRotationVector({0.02, -0.03, 1.3}), {3.0, -1.0, 0.6}};
  const std::vector<Gaussian3> submap =
      PointGaussians(HallPoints(2500, &random), kPointSigma, &random);
  const std::vector<Gaussian3> scan =
      PointGaussians(InFrame(T_true.Inverse(), HallPoints(400, &random)), kPointSigma, &random);
  for (const double side : {-1.0, 1.0}) {
    const Rigid3 T_start{
        QuaternionFromRotationVector(side * Eigen::Vector3d(0.01, -0.01, 0.02)) * T_true.rotation,
        T_true.translation + side * Eigen::Vector3d(0.25, -0.2, 0.1)};
    const RegistrationResult result = Align(scan, submap, T_start);
    ASSERT_TRUE(result.converged) << result.message;
    // Points between the submap's points are drawn to them; planes fill the gaps.
    const double tolerance = HasSurfaces() ? 0.02 : 0.08;
    EXPECT_LT((result.T_submap_radar.translation - T_true.translation).norm(), tolerance);
    EXPECT_LT(RotationError(result.T_submap_radar, T_true), 0.2 * tolerance);
    EXPECT_GT(result.num_pairs, 250);
    EXPECT_GE(result.num_iterations, 2);
    if (HasSurfaces()) {
      EXPECT_FALSE(result.degenerate());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(result.covariance);
    EXPECT_GT(eigen.eigenvalues()[0], 0.0);
    EXPECT_LT(eigen.eigenvalues()[5], 0.01);
  }
}

// A sensor without elevation: everything lies in one plane, and normals in it.
TEST_P(EveryMethod, RecoversTheTruthInThePlane) {
  Random random(2);
  const Rigid3 T_true{QuaternionFromRotationVector({0.0, 0.0, 0.7}), {2.0, 1.0, 0.0}};
  const auto flat = [&random](int count) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector3d& p : HallPoints(count, &random)) {
      if (p.z() > 0.0) points.emplace_back(p.x(), p.y(), 0.0);
    }
    return points;
  };
  std::vector<Gaussian3> submap = PointGaussians(flat(2000), 0.0, &random);
  std::vector<Gaussian3> scan = PointGaussians(InFrame(T_true.Inverse(), flat(300)), 0.0, &random);
  for (std::vector<Gaussian3>* gaussians : {&submap, &scan}) {
    for (Gaussian3& gaussian : *gaussians) gaussian.mean.z() = 0.0;
  }
  input_.is_planar = true;
  input_.priors.plane_normal = Eigen::Vector3d::UnitZ();
  const Rigid3 T_start{QuaternionFromRotationVector({0.0, 0.0, 0.72}), {2.2, 0.8, 0.0}};
  const RegistrationResult result = Align(scan, submap, T_start);
  ASSERT_TRUE(result.converged) << result.message;
  EXPECT_LT((result.T_submap_radar.translation - T_true.translation).norm(), 0.03);
  EXPECT_LT(RotationError(result.T_submap_radar, T_true), 0.004);
  EXPECT_EQ(result.T_submap_radar.translation.z(), 0.0);
}

TEST_P(EveryMethod, SaysWhatIsTooLittle) {
  Random random(3);
  const std::vector<Gaussian3> submap = PointGaussians(HallPoints(500, &random), 0.0, &random);
  const std::vector<Gaussian3> few = PointGaussians(HallPoints(9, &random), 0.0, &random);
  EXPECT_EQ(Align(few, submap, Rigid3()).message, "9 Gaussians in the scan, 10 needed");
  const std::vector<Gaussian3> scan = PointGaussians(HallPoints(100, &random), 0.0, &random);
  EXPECT_EQ(Align(scan, {}, Rigid3()).message, "0 pairs with the submap, 10 needed");
  const Rigid3 far{Eigen::Quaterniond::Identity(), {500.0, 0.0, 0.0}};
  const RegistrationResult result = Align(scan, submap, far);
  EXPECT_EQ(result.message, "0 pairs with the submap, 10 needed");
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.T_submap_radar.translation, far.translation) << "the prediction stays";
}

// All points in one place, or on one line: no surface for those methods that need one, and for all
// an answer that is finite or refused.
TEST_P(EveryMethod, DegenerateShapesGiveNoNonsense) {
  std::vector<Gaussian3> line(200), heap(200);
  for (std::size_t i = 0; i < line.size(); ++i) line[i].mean.x() = 0.1 * static_cast<double>(i);
  for (const std::vector<Gaussian3>& shape : {line, heap}) {
    const RegistrationResult result = Align(shape, shape, Rigid3());
    if (HasSurfaces()) {
      EXPECT_EQ(result.message, "0 pairs with the submap, 10 needed");
    } else {
      EXPECT_LT(result.T_submap_radar.translation.norm(), 0.1);
      EXPECT_TRUE(result.covariance.allFinite());
      EXPECT_TRUE(result.degenerate());
    }
  }
}

TEST_P(EveryMethod, SameInputSameBytes) {
  Random random(4);
  const std::vector<Gaussian3> submap = PointGaussians(HallPoints(1000, &random), 0.1, &random);
  const std::vector<Gaussian3> scan = PointGaussians(HallPoints(200, &random), 0.1, &random);
  const Rigid3 T_start{Eigen::Quaterniond::Identity(), {0.2, 0.1, 0.0}};
  const RegistrationResult first = Align(scan, submap, T_start);
  const RegistrationResult second = Align(scan, submap, T_start);
  EXPECT_EQ(ToPoseBlock(first.T_submap_radar), ToPoseBlock(second.T_submap_radar));
  EXPECT_EQ(first.covariance, second.covariance);
}

// Pairs that are left out for having no weight change nothing.
TEST(FullNdt, EqualsTheSumOverAllPairs) {
  Random random(5);
  const std::vector<Gaussian3> submap = PointGaussians(HallPoints(600, &random), 0.1, &random);
  const std::vector<Gaussian3> scan = PointGaussians(HallPoints(150, &random), 0.1, &random);
  const PairSearch search(submap);
  const Rigid3 T_start{QuaternionFromRotationVector({0.0, 0.0, 0.02}), {0.3, 0.2, 0.0}};
  RegistrationOptions options = Patient();
  options.method = RegistrationMethod::kFullNdt;
  const RegistrationResult full =
      RegisterNdt(scan, search, T_start, 0.5, RegistrationPriors(), PairOptions(), options);
  options.method = RegistrationMethod::kNdt;
  PairOptions all;
  all.bound = PairOptions::Bound::kNone;
  const RegistrationResult sum =
      RegisterNdt(scan, search, T_start, 0.5, RegistrationPriors(), all, options);
  ASSERT_TRUE(full.converged && sum.converged);
  EXPECT_LT(full.num_pairs, sum.num_pairs);
  // The larger constant of all pairs ends the solve a little earlier.
  EXPECT_LT((full.T_submap_radar.translation - sum.T_submap_radar.translation).norm(), 1e-4);
  EXPECT_LT(RotationError(full.T_submap_radar, sum.T_submap_radar), 1e-5);
  EXPECT_LT((full.covariance - sum.covariance).norm(), 1e-3 * sum.covariance.norm());
}

// Two bare walls along x: planes say nothing of the way along them, range rates do.
TEST(DopplerIcp, KnowsTheWayAlongACorridor) {
  Random random(6);
  const auto walls = [&random](int count) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < count; ++i) {
      points.emplace_back(
          random.Uniform(-30.0, 30.0), i % 2 == 0 ? -4.0 : 5.0, random.Uniform(0.0, 3.0));
    }
    return points;
  };
  const std::vector<Gaussian3> submap = PointGaussians(walls(3000), kPointSigma, &random);
  const Rigid3 T_true{Eigen::Quaterniond::Identity(), {1.0, 0.0, 0.0}};  // 10 m/s, 0.1 s
  const std::vector<Eigen::Vector3d> seen = InFrame(T_true.Inverse(), walls(400));
  const std::vector<Gaussian3> scan = PointGaussians(seen, kPointSigma, &random);
  std::vector<RadarReturn> returns;
  for (const Eigen::Vector3d& p : seen) {
    RadarReturn measured;
    measured.position = p;
    measured.doppler = -10.0 * p.normalized().x() + 0.05 * random.Normal();
    returns.push_back(measured);
  }
  const std::vector<double> weights(returns.size(), 1.0);
  const PairSearch search(submap);
  RegistrationInput input;
  input.scan = &scan;
  input.search = &search;
  input.T_prediction = {Eigen::Quaterniond::Identity(), {1.4, 0.1, 0.0}};
  input.priors.plane_normal = Eigen::Vector3d::UnitZ();
  input.doppler = {&returns, &weights, Rigid3(), 0.1, 0.05};
  RegistrationOptions options = Patient();
  options.method = RegistrationMethod::kDopplerIcp;
  const RegistrationResult with_doppler = Register(input, PairOptions(), options);
  options.method = RegistrationMethod::kPlaneIcp;
  const RegistrationResult planes = Register(input, PairOptions(), options);
  ASSERT_TRUE(with_doppler.converged && planes.converged);
  EXPECT_NEAR(with_doppler.T_submap_radar.translation.x(), 1.0, 0.005);
  EXPECT_NEAR(with_doppler.T_submap_radar.translation.y(), 0.0, 0.02);
  EXPECT_FALSE(with_doppler.degenerate());
  EXPECT_GT(planes.T_submap_radar.translation.x(), 1.2);
  EXPECT_NEAR(planes.T_submap_radar.translation.y(), 0.0, 0.02);
  EXPECT_TRUE(planes.degenerate());
}

}  // namespace
}  // namespace radive
