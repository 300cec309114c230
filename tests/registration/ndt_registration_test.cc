// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "radive/io/open/open_scan_source.h"
#include "radive/ndt/gaussian_builder.h"
#include "radive/preprocessing/preprocess.h"
#include "radive/registration/registration.h"
#include "tests/registration/street_registration.h"
#include "tests/shared_data.h"
#include "tests/synthetic_scene.h"

namespace radive {
namespace {

constexpr double kStreetSigma = 0.05;  // noise of the synthetic points [m]

using testing::Patient;
using testing::PointGaussians;
using testing::RotationError;
using testing::StreetScan;

RegistrationPriors Planar() {
  RegistrationPriors priors;
  priors.plane_normal = Eigen::Vector3d::UnitZ();
  return priors;
}

struct Start {
  Eigen::Vector3d rotation;     // [rad]
  Eigen::Vector3d translation;  // [m]
};

TEST(RegisterNdt, RecoversTheTruthFromPerturbedStarts) {
  Random random(1);
  const std::vector<Gaussian3> submap = PointGaussians(testing::StreetPoints(), 0.0, &random);
  const PairSearch search(submap);
  const Rigid3 T_true{QuaternionFromRotationVector({0.02, -0.03, 1.3}), {3.0, -1.0, 0.6}};
  const std::vector<Gaussian3> scan = StreetScan(T_true, 0.0, &random);
  for (const Start& start : {Start{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}},
                             Start{{0.0, 0.0, 0.02}, {0.3, 0.2, 0.0}},
                             Start{{0.01, -0.01, -0.02}, {-0.3, 0.1, 0.1}},
                             Start{{-0.01, 0.01, 0.01}, {0.2, -0.3, -0.1}}}) {
    const Rigid3 T_start{QuaternionFromRotationVector(start.rotation) * T_true.rotation,
                         T_true.translation + start.translation};
    const RegistrationResult result =
        RegisterNdt(scan, search, T_start, 0.7, RegistrationPriors(), PairOptions(), Patient());
    ASSERT_TRUE(result.converged) << result.message;
    EXPECT_TRUE(result.message.empty());
    // Neighbours 1.5 m away pull a little, on both sides; more where the street ends.
    EXPECT_LT((result.T_submap_radar.translation - T_true.translation).norm(), 0.02);
    EXPECT_LT(RotationError(result.T_submap_radar, T_true), 1e-3);
    EXPECT_GT(result.num_pairs, 150);
    if (!start.translation.isZero()) {
      EXPECT_GE(result.num_iterations, 2);
    }
    EXPECT_FALSE(result.degenerate());
  }
}

// Scan and submap change places: the answer is the inverse.
TEST(RegisterNdt, BothDirectionsAgree) {
  Random random(2);
  const Rigid3 T_true{QuaternionFromRotationVector({0.0, 0.01, 0.05}), {0.4, 0.2, 0.05}};
  const std::vector<Gaussian3> a = PointGaussians(testing::StreetPoints(), kStreetSigma, &random);
  const std::vector<Gaussian3> b = testing::Transformed(
      T_true.Inverse(), PointGaussians(testing::StreetPoints(), kStreetSigma, &random));
  const RegistrationResult forward =
      RegisterNdt(b, PairSearch(a), Rigid3(), 0.8, RegistrationPriors(), PairOptions(), Patient());
  const RegistrationResult backward =
      RegisterNdt(a, PairSearch(b), Rigid3(), 0.8, RegistrationPriors(), PairOptions(), Patient());
  ASSERT_TRUE(forward.converged && backward.converged);
  EXPECT_LT((forward.T_submap_radar.translation - T_true.translation).norm(), 0.03);
  const Rigid3 loop = forward.T_submap_radar * backward.T_submap_radar;
  EXPECT_LT(loop.translation.norm(), 0.01);
  EXPECT_LT(RotationVector(loop.rotation).norm(), 1e-3);
}

TEST(RegisterNdt, PlanarModeMovesInThePlaneOnly) {
  Random random(3);
  const std::vector<Gaussian3> submap = PointGaussians(testing::StreetPoints(), 0.0, &random);
  const Rigid3 T_true{QuaternionFromRotationVector({0.0, 0.0, 0.7}), {1.0, 0.5, 0.4}};
  const std::vector<Gaussian3> scan = StreetScan(T_true, 0.0, &random);
  // 0.1 m too high and tilted: neither may be repaired.
  const Eigen::Quaterniond tilt = QuaternionFromRotationVector({0.01, 0.0, 0.0});
  const Rigid3 T_start{QuaternionFromRotationVector({0.0, 0.0, 0.03}) * tilt * T_true.rotation,
                       {1.3, 0.2, 0.5}};
  const RegistrationResult result =
      RegisterNdt(scan, PairSearch(submap), T_start, 0.7, Planar(), PairOptions(), Patient());
  ASSERT_TRUE(result.converged) << result.message;
  EXPECT_NEAR(result.T_submap_radar.translation.z(), 0.5, 1e-9);
  const Eigen::Vector3d turned =
      RotationVector(result.T_submap_radar.rotation * T_start.rotation.conjugate());
  EXPECT_LT(turned.head<2>().norm(), 1e-9);
  EXPECT_LT((result.T_submap_radar.translation - T_true.translation).head<2>().norm(), 0.02);
  EXPECT_NEAR(turned.z(), -0.03, 2e-3);
  // Held directions have no variance, the others have some.
  for (const int i : {0, 1, 5}) EXPECT_LT(std::abs(result.covariance(i, i)), 1e-15) << i;
  for (const int i : {2, 3, 4}) EXPECT_GT(result.covariance(i, i), 1e-9) << i;
}

// Far from the origin of the map nothing may change.
TEST(RegisterNdt, MapCoordinatesOfAMillionMetres) {
  Random random(4);
  const std::vector<Gaussian3> submap =
      PointGaussians(testing::StreetPoints(), kStreetSigma, &random);
  const Rigid3 T_true{QuaternionFromRotationVector({0.0, 0.0, 0.7}), {1.0, 0.5, 0.4}};
  const std::vector<Gaussian3> scan = StreetScan(T_true, kStreetSigma, &random);
  const Rigid3 T_start{T_true.rotation, T_true.translation + Eigen::Vector3d(0.2, -0.1, 0.05)};
  const Rigid3 T_far_submap{Eigen::Quaterniond::Identity(), {1e6, -1e6, 1e4}};
  const std::vector<Gaussian3> far_submap = testing::Transformed(T_far_submap, submap);
  const RegistrationResult near = RegisterNdt(
      scan, PairSearch(submap), T_start, 0.5, RegistrationPriors(), PairOptions(), Patient());
  const RegistrationResult far = RegisterNdt(scan,
                                             PairSearch(far_submap),
                                             T_far_submap * T_start,
                                             0.5,
                                             RegistrationPriors(),
                                             PairOptions(),
                                             Patient());
  ASSERT_TRUE(near.converged && far.converged) << far.message;
  const Rigid3 expected = T_far_submap * near.T_submap_radar;
  EXPECT_LT((far.T_submap_radar.translation - expected.translation).norm(), 1e-5);
  EXPECT_LT(RotationError(far.T_submap_radar, expected), 1e-6);
}

TEST(RegisterNdt, SaysWhyItDidNotConverge) {
  Random random(5);
  const std::vector<Gaussian3> submap = PointGaussians(testing::StreetPoints(), 0.0, &random);
  const PairSearch search(submap);
  const Rigid3 T_start{Eigen::Quaterniond::Identity(), {0.5, 0.0, 0.0}};
  std::vector<Gaussian3> scan = StreetScan(Rigid3(), 0.0, &random);
  RegistrationOptions options = Patient();

  const std::vector<Gaussian3> few(scan.begin(), scan.begin() + 9);
  RegistrationResult result =
      RegisterNdt(few, search, T_start, 0.5, RegistrationPriors(), PairOptions(), options);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.message, "9 Gaussians in the scan, 10 needed");

  const Rigid3 far{Eigen::Quaterniond::Identity(), {500.0, 0.0, 0.0}};
  result = RegisterNdt(scan, search, far, 0.5, RegistrationPriors(), PairOptions(), options);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.message, "0 pairs with the submap, 10 needed");
  EXPECT_EQ(result.T_submap_radar.translation, far.translation) << "the prediction stays";

  result = RegisterNdt({}, search, far, 0.5, RegistrationPriors(), PairOptions(), options);
  EXPECT_FALSE(result.converged);

  const std::vector<Gaussian3> nothing;
  result = RegisterNdt(
      scan, PairSearch(nothing), T_start, 0.5, RegistrationPriors(), PairOptions(), options);
  EXPECT_EQ(result.message, "0 pairs with the submap, 10 needed");

  options.max_correction = 0.3;
  result = RegisterNdt(scan, search, T_start, 0.7, RegistrationPriors(), PairOptions(), options);
  EXPECT_FALSE(result.converged);
  EXPECT_NE(result.message.find("from the prediction"), std::string::npos) << result.message;
  EXPECT_EQ(result.T_submap_radar.translation, T_start.translation) << "the prediction stays";
}

// Two bare walls along x: nothing tells how far along them the radar is.
TEST(RegisterNdt, FindsTheWeakDirectionOfACorridor) {
  Random random(6);
  const auto corridor = [&random](double yaw, double length, int count) {
    std::vector<Gaussian3> gaussians;
    const Eigen::Quaterniond q = QuaternionFromRotationVector({0.0, 0.0, yaw});
    for (int i = 0; i < count; ++i) {
      Gaussian3 gaussian;
      gaussian.mean =
          q * Eigen::Vector3d(random.Uniform(-length, length),
                              (i % 2 == 0 ? -5.0 : 6.0) + kStreetSigma * random.Normal(),
                              random.Uniform(0.0, 3.0));
      gaussian.covariance = 0.05 * Eigen::Matrix3d::Identity();
      gaussians.push_back(gaussian);
    }
    return gaussians;
  };
  for (const double yaw : {0.0, 0.6}) {
    const std::vector<Gaussian3> submap = corridor(yaw, 60.0, 3000);
    const std::vector<Gaussian3> scan = corridor(yaw, 30.0, 150);
    const RegistrationResult result = RegisterNdt(
        scan, PairSearch(submap), Rigid3(), 0.5, Planar(), PairOptions(), RegistrationOptions());
    ASSERT_TRUE(result.converged) << result.message;
    ASSERT_EQ(result.weak_directions.size(), 1u);
    const Eigen::Matrix<double, 6, 1> weak = result.weak_directions[0];
    EXPECT_LT(weak.head<3>().norm(), 1e-9) << "a translation, not a rotation";
    const double along = weak[3] * std::cos(yaw) + weak[4] * std::sin(yaw);
    EXPECT_GT(std::abs(along), 0.99) << weak.transpose();
  }
}

// In the corridor a translation prior decides on the way along it, and not on the way across.
TEST(RegisterNdt, PriorsPullAsTheirCovarianceSays) {
  Random random(7);
  // Scan and submap of the street, exact, prior 0.2 m off along x.
  const std::vector<Gaussian3> submap = PointGaussians(testing::StreetPoints(), 0.0, &random);
  const PairSearch search(submap);
  const Rigid3 T_true{Eigen::Quaterniond::Identity(), {1.0, 0.0, 0.5}};
  const std::vector<Gaussian3> scan = StreetScan(T_true, 0.0, &random);
  const RegistrationResult free =
      RegisterNdt(scan, search, T_true, 0.5, RegistrationPriors(), PairOptions(), Patient());
  ASSERT_TRUE(free.converged);
  double last_offset = 1.0;
  for (const double sigma : {1e-4, 0.01, 0.03, 0.1, 1.0}) {
    RegistrationPriors priors;
    priors.translation =
        RegistrationPriors::Translation{T_true.translation + Eigen::Vector3d(0.2, 0.0, 0.0),
                                        sigma * sigma * Eigen::Matrix3d::Identity()};
    const RegistrationResult result =
        RegisterNdt(scan, search, T_true, 0.5, priors, PairOptions(), Patient());
    ASSERT_TRUE(result.converged);
    const double offset = (result.T_submap_radar.translation - free.T_submap_radar.translation).x();
    EXPECT_LT(offset, last_offset) << "a weaker prior pulls less";
    last_offset = offset;
    if (sigma == 1e-4) {
      EXPECT_NEAR(offset, 0.2, 5e-3);
    }
    if (sigma == 1.0) {
      EXPECT_NEAR(offset, 0.0, 1e-3);
    }
  }
  // Each of the other priors, strong, at a place of its own.
  RegistrationPriors rotation;
  const Eigen::Quaterniond q = QuaternionFromRotationVector({0.0, 0.0, 0.01});
  rotation.rotation = RegistrationPriors::Rotation{q, 1e-10 * Eigen::Matrix3d::Identity()};
  RegistrationResult result =
      RegisterNdt(scan, search, T_true, 0.5, rotation, PairOptions(), Patient());
  EXPECT_LT(RotationVector(result.T_submap_radar.rotation * q.conjugate()).norm(), 1e-4);

  RegistrationPriors attitude;
  attitude.attitude_height = RegistrationPriors::AttitudeHeight{
      Eigen::Vector3d::UnitZ(), Eigen::Vector3d(0.02, 0.0, 1.0), {0.0, 0.0, 0.6}, 1e-5, 1e-5};
  result = RegisterNdt(scan, search, T_true, 0.5, attitude, PairOptions(), Patient());
  const Eigen::Vector3d up = result.T_submap_radar.rotation * Eigen::Vector3d::UnitZ();
  EXPECT_LT((up - Eigen::Vector3d(0.02, 0.0, 1.0).normalized()).norm(), 1e-3);
  const Eigen::Vector3d n = Eigen::Vector3d(0.02, 0.0, 1.0).normalized();
  EXPECT_NEAR(n.dot(result.T_submap_radar.translation - Eigen::Vector3d(0.0, 0.0, 0.6)), 0.0, 2e-3);

  // 0.3 m along the radar's x axis from (0.8, 0, 0.5).
  RegistrationPriors displacement;
  displacement.displacement =
      RegistrationPriors::Displacement{Rigid3(Eigen::Quaterniond::Identity(), {0.8, 0.0, 0.5}),
                                       {0.3, 0.0, 0.0},
                                       1e-10 * Eigen::Matrix3d::Identity()};
  result = RegisterNdt(scan, search, T_true, 0.5, displacement, PairOptions(), Patient());
  EXPECT_NEAR(result.T_submap_radar.translation.x(), 1.1, 1e-3);

  RegistrationPriors no_slip;
  no_slip.no_slip = RegistrationPriors::NoSlip{
      Rigid3(Eigen::Quaterniond::Identity(), {0.0, 0.1, 0.5}), Rigid3(), 0.0, 1e-6};
  no_slip.rotation = RegistrationPriors::Rotation{Eigen::Quaterniond::Identity(),
                                                  1e-12 * Eigen::Matrix3d::Identity()};
  result = RegisterNdt(scan, search, T_true, 0.5, no_slip, PairOptions(), Patient());
  EXPECT_NEAR(result.T_submap_radar.translation.y(), 0.1, 1e-3);
}

// Consecutive scans of a real drive, in both modes: analytic and autodiff derivatives end at the
// same place.
TEST(RegisterNdt, AnalyticAndAutodiffAgreeOnRealScans) {
  RADIVE_SKIP_WITHOUT("vod-radar-xyz/delft_06");
  std::string error;
  InputOptions input;
  input.layout = "xyz3";
  const auto source =
      OpenScanSource((testing::SharedData() / "vod-radar-xyz/delft_06").string(), input, &error);
  ASSERT_NE(source, nullptr) << error;
  PreprocessingOptions preprocessing;
  preprocessing.max_range = 60.0;
  std::vector<std::vector<Gaussian3>> scans;
  RadarScan raw;
  while (scans.size() < 12 && source->Next(&raw) == ScanSource::Status::kScan) {
    const std::vector<RadarReturn> returns =
        Preprocess(raw, SensorOptions(), preprocessing, nullptr);
    scans.push_back(GaussiansOfReturns(
        returns, std::vector<double>(returns.size(), 1.0), SensorOptions(), NdtOptions()));
  }
  ASSERT_EQ(scans.size(), 12u);
  int num_compared = 0;
  for (const bool planar : {true, false}) {
    for (std::size_t i = 1; i < scans.size(); ++i) {
      // A 6-DoF pose of a hundred noisy points needs its tilt held, as odometry does.
      RegistrationPriors priors = planar ? Planar() : RegistrationPriors();
      if (!planar) {
        priors.rotation = RegistrationPriors::Rotation{Eigen::Quaterniond::Identity(),
                                                       1e-4 * Eigen::Matrix3d::Identity()};
        priors.translation = RegistrationPriors::Translation{Eigen::Vector3d::Zero(),
                                                             0.3 * Eigen::Matrix3d::Identity()};
      }
      RegistrationResult results[2];
      for (const bool analytic : {false, true}) {
        RegistrationOptions options;
        options.derivatives = analytic ? NdtDerivatives::kAnalytic : NdtDerivatives::kAutodiff;
        options.num_associations = 1;
        options.max_iterations = 500;
        options.step_tolerance = 1e-9;
        options.step_deviations = 0.0;
        results[analytic] = RegisterNdt(
            scans[i], PairSearch(scans[i - 1]), Rigid3(), 0.7, priors, PairOptions(), options);
      }
      ASSERT_EQ(results[0].converged, results[1].converged);
      if (!results[0].converged) continue;
      ++num_compared;
      EXPECT_LT(
          (results[0].T_submap_radar.translation - results[1].T_submap_radar.translation).norm(),
          1e-4)
          << "scan " << i << (planar ? " planar" : "");
      EXPECT_LT(RotationError(results[0].T_submap_radar, results[1].T_submap_radar), 1e-5)
          << "scan " << i << (planar ? " planar" : "");
    }
  }
  EXPECT_GE(num_compared, 16);
}

}  // namespace
}  // namespace radive
