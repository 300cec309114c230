// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/ego_velocity_estimator.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "radive/simulation/radar_simulator.h"
#include "tests/ego_velocity/made_returns.h"

namespace radive {
namespace {

using testing::At;
using ::testing::HasSubstr;
using testing::kTenthSecond;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
EgoVelocity FitOne(const std::vector<RadarReturn>& returns, bool is_planar) {
  EgoVelocityEstimator estimator({}, {});
  return estimator.Estimate(returns, is_planar, 0);
}

// At 10 m/s ahead and 5 m/s to the left: ahead -10, to the left -5, at (3, 4) -(6 + 4), at (4, -3)
// -(8 - 3), at (-3, 4) -(-6 + 4).
TEST(EgoVelocityEstimator, FindsTheVelocityOfAHandMadeScan) {
  const std::vector<RadarReturn> returns = {
      At(20, 0, -10), At(0, 7, -5), At(3, 4, -10), At(40, -30, -5), At(-3, 4, 2), At(9, 9, 3)};
  const EgoVelocity velocity = FitOne(returns, /*is_planar=*/true);
  ASSERT_TRUE(velocity.valid) << velocity.reason;
  EXPECT_LT((velocity.v_radar - Eigen::Vector3d(10.0, 5.0, 0.0)).norm(), 1e-9);
  EXPECT_EQ(velocity.num_inliers, 5);  // the last one drives away
  EXPECT_EQ(velocity.num_returns, 6);
  EXPECT_NEAR(velocity.residual_rms, 0.0, 1e-9);
  EXPECT_FALSE(velocity.is_standing);
}

// Normalised error squared over many scans of known noise: chi-square with three degrees of
// freedom each. The true vertical velocity is drawn as vertical_sigma says.
double MeanSquaredError(bool is_planar, int num_returns, int num_scans) {
  EgoVelocityOptions options;
  options.common_sigma = 0.0;
  Random random(17);
  testing::ReturnsModel model;
  if (is_planar) model.half_elevation = 0.0;
  double sum = 0.0;
  for (int k = 0; k < num_scans; ++k) {
    const Eigen::Vector3d truth(12.0, 0.5, options.vertical_sigma * random.Normal());
    const auto returns = testing::MakeStaticReturns(num_returns, truth, model, &random);
    EgoVelocityEstimator estimator(options, SensorOptions());
    const EgoVelocity velocity = estimator.Estimate(returns, is_planar, 0);
    EXPECT_TRUE(velocity.valid) << velocity.reason;
    const Eigen::Vector3d error = velocity.v_radar - truth;
    sum += error.dot(velocity.covariance.ldlt().solve(error));
  }
  return sum / num_scans;
}

TEST(EgoVelocityEstimator, CovarianceMatchesTheErrorsOfMadeScans) {
  const int num_scans = 1000;
  const double band = 4.0 * std::sqrt(2.0 * 3.0 / num_scans);  // 4 sigma of the mean: 0.31
  EXPECT_NEAR(MeanSquaredError(/*is_planar=*/false, 200, num_scans), 3.0, band);
  EXPECT_NEAR(MeanSquaredError(/*is_planar=*/true, 200, num_scans), 3.0, band);
}

struct Errors {
  int num_scans = 0;
  int num_invalid = 0;
  double squared = 0.0;  // mean horizontal normalised error squared
  double worst = 0.0;    // largest horizontal error [m/s]
  std::vector<double> all_velocities;
};

Errors DriveScenario(const std::string& scenario, int frames, const EgoVelocityOptions& options) {
  SimulationOptions simulation = ScenarioOptions(scenario).value();
  simulation.frames = frames;
  RadarSimulator simulator(simulation);
  EgoVelocityEstimator estimator(options, SensorOptions());
  RadarScan scan;
  GroundTruth truth;
  Errors errors;
  while (simulator.Next(&scan, &truth)) {
    const EgoVelocity velocity = estimator.Estimate(scan.returns, scan.is_planar, scan.stamp_ns);
    ++errors.num_scans;
    if (!velocity.valid) ++errors.num_invalid;
    const Eigen::Vector2d error = (velocity.v_radar - truth.v_radar).head<2>();
    const Eigen::Matrix2d covariance = velocity.covariance.topLeftCorner<2, 2>();
    errors.squared += error.dot(covariance.ldlt().solve(error));
    errors.worst = std::max(errors.worst, error.norm());
    for (int i = 0; i < 3; ++i) errors.all_velocities.push_back(velocity.v_radar[i]);
  }
  errors.squared /= errors.num_scans;
  return errors;
}

// Simulated drives have noise in the angles too, traffic, ghosts and clutter: the errors stay
// within a wider band around the two degrees of freedom.
TEST(EgoVelocityEstimator, FollowsSimulatedDrives) {
  EgoVelocityOptions options;
  options.common_sigma = 0.0;
  const Errors dense = DriveScenario("street_dense", 250, options);
  const Errors sparse = DriveScenario("street_sparse", 1200, options);
  for (const Errors& errors : {dense, sparse}) {
    EXPECT_EQ(errors.num_invalid, 0);
    EXPECT_GT(errors.squared, 1.2);
    EXPECT_LT(errors.worst, 0.2);
  }
  EXPECT_LT(sparse.squared, 3.0);
  // Returns of one target share their errors in angle, so that there are fewer independent ones
  // than the covariance counts.
  EXPECT_LT(dense.squared, 15.0);
  // The planar sensor takes slanting returns for level ones, which shortens the speed by 5 mm/s.
  const Errors planar = DriveScenario("street_planar", 800, options);
  EXPECT_EQ(planar.num_invalid, 0);
  EXPECT_GT(planar.squared, 1.2);
  EXPECT_LT(planar.squared, 4.0);
  EXPECT_LT(planar.worst, 0.2);
}

TEST(EgoVelocityEstimator, SameScansSameBytes) {
  EgoVelocityOptions options;
  const Errors first = DriveScenario("street_sparse", 60, options);
  const Errors second = DriveScenario("street_sparse", 60, options);
  EXPECT_EQ(first.all_velocities, second.all_velocities);
}

// A street seen by 40 returns, and from the second scan on a car ahead, 4 m/s faster, that owns 80.
class PassingCar : public ::testing::Test {
 protected:
  EgoVelocity DriveBehindIt(const EgoVelocityOptions& options) {
    Random random(9);
    EgoVelocityEstimator estimator(options, SensorOptions());
    EgoVelocity velocity;
    for (int k = 0; k < 20; ++k) {
      auto returns = testing::MakeStaticReturns(40, v_radar_, model_, &random);
      if (k > 0) {
        const auto car = testing::MakeReturns(80, v_radar_, {14.0, 0.0, 0.0}, model_, &random);
        returns.insert(returns.end(), car.begin(), car.end());
      }
      velocity = estimator.Estimate(returns, /*is_planar=*/false, k * kTenthSecond);
      EXPECT_TRUE(velocity.valid) << velocity.reason;
    }
    return velocity;
  }

  const Eigen::Vector3d v_radar_ = {10.0, 0.2, 0.0};
  const testing::ReturnsModel model_;
};

TEST_F(PassingCar, IsNotTakenForTheStreetBehindTheTemporalGate) {
  const EgoVelocity velocity = DriveBehindIt(EgoVelocityOptions());
  EXPECT_LT((velocity.v_radar - v_radar_).norm(), 0.15);
  EXPECT_GE(velocity.num_inliers, 38);
}

TEST_F(PassingCar, IsTakenForTheStreetWithoutTheTemporalGate) {
  EgoVelocityOptions options;
  options.temporal_gate = 0.0;
  // Relative to the car the radar falls back with 4 m/s.
  EXPECT_NEAR(DriveBehindIt(options).v_radar.x(), -4.0, 0.2);
}

TEST(EgoVelocityEstimator, TheGateWidensUntilTheVelocityIsFoundAgain) {
  const testing::ReturnsModel model;
  Random random(4);
  EgoVelocityOptions options;  // 1.5 m/s and 8 m/s^2
  EgoVelocityEstimator estimator(options, SensorOptions());
  const auto before = testing::MakeStaticReturns(100, {10.0, 0.0, 0.0}, model, &random);
  const auto after = testing::MakeStaticReturns(100, {15.0, 0.0, 0.0}, model, &random);
  const EgoVelocity first = estimator.Estimate(before, false, 0);
  ASSERT_TRUE(first.valid);
  // 5 m/s more: out of reach after 0.1 s and 0.3 s (2.3 and 3.9 m/s), within it after 0.5 s (5.5).
  for (const int tenths : {1, 3}) {
    const EgoVelocity lost = estimator.Estimate(after, false, tenths * kTenthSecond);
    EXPECT_FALSE(lost.valid);
    EXPECT_THAT(lost.reason, HasSubstr("agree"));
    EXPECT_EQ(lost.v_radar, first.v_radar);  // kept
    const double change = 0.8 * tenths;      // [m/s]
    EXPECT_NEAR(lost.covariance(0, 0), first.covariance(0, 0) + change * change, 1e-9);
  }
  const EgoVelocity found = estimator.Estimate(after, false, 5 * kTenthSecond);
  EXPECT_TRUE(found.valid) << found.reason;
  EXPECT_NEAR(found.v_radar.x(), 15.0, 0.1);
}

// After a dozen scans of even driving, 2 m/s sideways within 0.1 s (a scan that is turned by 11
// deg) are no motion: 0.5 m/s and 0.8 m/s by acceleration are believed. RANSAC's gate of 2.3 m/s is
// wider.
TEST(EgoVelocityEstimator, BelievesAfterEvenDrivingNoLeap) {
  for (const double sideways : {1.0, 2.0}) {
    for (const int num_scans : {3, 12}) {
      Random random(4);
      EgoVelocityEstimator estimator(EgoVelocityOptions{}, SensorOptions{});
      for (int k = 0; k < num_scans; ++k) {
        const auto even = testing::MakeStaticReturns(100, {10.0, 0.0, 0.0}, {}, &random);
        ASSERT_TRUE(estimator.Estimate(even, false, k * kTenthSecond).valid);
      }
      const auto leap = testing::MakeStaticReturns(100, {10.0, sideways, 0.0}, {}, &random);
      const EgoVelocity velocity = estimator.Estimate(leap, false, num_scans * kTenthSecond);
      EXPECT_EQ(velocity.valid, sideways == 1.0 || num_scans == 3) << velocity.reason;
      if (velocity.valid) continue;
      EXPECT_THAT(velocity.reason, HasSubstr("at most 1.30 after those before"));
      // It goes on from the last velocity that was believed.
      const auto even = testing::MakeStaticReturns(100, {10.0, 0.0, 0.0}, {}, &random);
      EXPECT_TRUE(estimator.Estimate(even, false, (num_scans + 1) * kTenthSecond).valid);
    }
  }
}

TEST(EgoVelocityEstimator, GivesUpWhenAllReturnsMove) {
  Random random(2);
  auto returns = testing::MakeStaticReturns(100, {10.0, 0.0, 0.0}, {}, &random);
  for (RadarReturn& entry : returns) entry.doppler = random.Uniform(-30.0, 30.0);
  const EgoVelocity velocity = FitOne(returns, false);
  EXPECT_FALSE(velocity.valid);
  EXPECT_THAT(velocity.reason, HasSubstr("of 100 returns agree on a velocity, 20 needed"));
  EXPECT_EQ(velocity.v_radar, Eigen::Vector3d::Zero());
}

TEST(EgoVelocityEstimator, SaysThatThereAreTooFewReturns) {
  EXPECT_EQ(FitOne({}, false).reason, "0 returns with Doppler, at least 5 needed");
  EXPECT_EQ(FitOne({At(10, 0, -5), At(0, 10, 0)}, true).reason,
            "2 returns with Doppler, at least 5 needed");
  // Without Doppler, at the origin and not finite: none of them counts.
  EXPECT_EQ(FitOne({At(10, 0, kNan), At(0, 0, 1), At(kNan, 1, 1), At(1, 1, 1)}, true).reason,
            "1 returns with Doppler, at least 5 needed");
}

TEST(EgoVelocityEstimator, UnusableReturnsChangeNothing) {
  Random random(6);
  const auto clean = testing::MakeStaticReturns(60, {8.0, 1.0, 0.0}, {}, &random);
  std::vector<RadarReturn> dirty;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    if (i % 7 == 0) dirty.push_back(At(10, 5, kNan));
    if (i % 9 == 0) dirty.push_back(At(0, 0, 3));
    if (i % 11 == 0) dirty.push_back(At(std::numeric_limits<double>::infinity(), 5, 1));
    dirty.push_back(clean[i]);
  }
  const EgoVelocity expected = FitOne(clean, false);
  const EgoVelocity actual = FitOne(dirty, false);
  ASSERT_TRUE(actual.valid);
  EXPECT_EQ(actual.v_radar, expected.v_radar);
  EXPECT_EQ(actual.covariance, expected.covariance);
  EXPECT_EQ(actual.num_returns, 60);
}

TEST(EgoVelocityEstimator, RefusesReturnsThatLieInOneDirection) {
  std::vector<RadarReturn> returns;
  for (int i = 1; i <= 20; ++i) returns.push_back(At(3.0 * i, 1.0 * i, -10.0));
  const EgoVelocity velocity = FitOne(returns, true);
  EXPECT_FALSE(velocity.valid);
  EXPECT_EQ(velocity.reason, "all returns lie in one direction");

  // With a velocity from before, there is a hypothesis to start from, and still nothing across.
  Random random(3);
  EgoVelocityEstimator estimator({}, {});
  const auto good = testing::MakeStaticReturns(60, {10.0, 0.5, 0.0}, {1.0, 0.0, 0.1}, &random);
  ASSERT_TRUE(estimator.Estimate(good, true, 0).valid);
  for (RadarReturn& entry : returns) {
    entry.doppler = -entry.position.normalized().dot(Eigen::Vector3d(10.0, 0.5, 0.0));
  }
  const EgoVelocity next = estimator.Estimate(returns, true, kTenthSecond);
  EXPECT_FALSE(next.valid);
  EXPECT_THAT(next.reason, HasSubstr("too close to one direction"));
  EXPECT_NEAR(next.v_radar.x(), 10.0, 0.2);

  // A narrow fan is refused as well: 0.1 m/s over 20 returns within half a degree leave 5 m/s.
  for (RadarReturn& entry : returns) entry.position.y() += random.Uniform(-0.1, 0.1);
  EXPECT_FALSE(estimator.Estimate(returns, true, 2 * kTenthSecond).valid);
}

TEST(EgoVelocityEstimator, KnowsThatItStands) {
  Random random(8);
  auto returns = testing::MakeStaticReturns(100, Eigen::Vector3d::Zero(), {}, &random);
  const EgoVelocity noisy = FitOne(returns, false);
  ASSERT_TRUE(noisy.valid);
  EXPECT_TRUE(noisy.is_standing);
  for (RadarReturn& entry : returns) entry.doppler = 0.0;
  const EgoVelocity exact = FitOne(returns, false);
  ASSERT_TRUE(exact.valid);
  EXPECT_TRUE(exact.is_standing);
  EXPECT_LT(exact.v_radar.norm(), 1e-9);
  // Zero residuals do not claim zero noise.
  EXPECT_GT(exact.covariance(0, 0), 1e-5);
  const EgoVelocity crawling =
      FitOne(testing::MakeStaticReturns(100, {0.2, 0.0, 0.0}, {}, &random), false);
  EXPECT_FALSE(crawling.is_standing);
}

TEST(EgoVelocityEstimator, ReversesAndLooksAside) {
  Random random(5);
  for (const Eigen::Vector3d& truth :
       {Eigen::Vector3d(-3.0, 0.1, 0.0), Eigen::Vector3d(0.5, -20.0, 0.0)}) {
    const auto returns = testing::MakeStaticReturns(120, truth, {}, &random);
    const EgoVelocity velocity = FitOne(returns, false);
    ASSERT_TRUE(velocity.valid) << velocity.reason;
    EXPECT_LT((velocity.v_radar - truth).norm(), 0.1);
  }
}

// A radar that looks 30 degrees down on a level road: its own v_z is half of the speed, and not to
// be drawn to zero.
TEST(EgoVelocityEstimator, VerticalIsThatOfTheVehicle) {
  SensorOptions sensor;
  sensor.mount_pitch = 3.14159265358979323846 / 6.0;
  const Eigen::Vector3d truth =
      sensor.T_vehicle_radar().rotation.conjugate() * Eigen::Vector3d(10.0, 0.0, 0.0);
  EXPECT_NEAR(truth.z(), 5.0, 1e-12);
  Random random(11);
  const auto returns = testing::MakeStaticReturns(200, truth, {}, &random);
  EgoVelocityEstimator estimator(EgoVelocityOptions(), sensor);
  const EgoVelocity velocity = estimator.Estimate(returns, false, 0);
  ASSERT_TRUE(velocity.valid) << velocity.reason;
  EXPECT_LT((velocity.v_radar - truth).norm(), 0.1);
}

// A radar that climbs at 2 m/s; a third of the returns moves.
TEST(EgoVelocityEstimator, SpatialHypothesesFindTheVerticalVelocity) {
  Random random(3);
  testing::ReturnsModel model;
  model.half_elevation = 0.5;
  model.sigma_doppler = 0.02;
  const Eigen::Vector3d truth(8.0, 0.5, 2.0);
  std::vector<RadarReturn> returns = testing::MakeStaticReturns(300, truth, model, &random);
  for (const RadarReturn& entry :
       testing::MakeReturns(150, truth, {3.0, 1.0, -1.0}, model, &random)) {
    returns.push_back(entry);
  }
  EgoVelocityOptions options;
  options.hypotheses = EgoVelocityOptions::Hypotheses::kSpatial;
  options.vertical_ridge = 0.0;
  options.temporal_gate = 0.0;
  EgoVelocityEstimator spatial(options, SensorOptions());
  const EgoVelocity velocity = spatial.Estimate(returns, false, 0);
  ASSERT_TRUE(velocity.valid) << velocity.reason;
  EXPECT_LT((velocity.v_radar - truth).norm(), 0.05);
  EXPECT_GT(velocity.num_inliers, 290);

  // A planar sensor has no third direction: the same numbers as with planar hypotheses.
  model.half_elevation = 0.0;
  const auto flat = testing::MakeStaticReturns(100, {8.0, 0.5, 0.0}, model, &random);
  options.hypotheses = EgoVelocityOptions::Hypotheses::kPlanar;
  EgoVelocityEstimator planar(options, SensorOptions());
  options.hypotheses = EgoVelocityOptions::Hypotheses::kSpatial;
  EgoVelocityEstimator spatial_of_planar(options, SensorOptions());
  EXPECT_EQ(spatial_of_planar.Estimate(flat, true, 0).v_radar,
            planar.Estimate(flat, true, 0).v_radar);
}

TEST(EgoVelocityOptions, NamesTheFieldThatIsOutOfRange) {
  std::string error;
  EgoVelocityOptions options;
  EXPECT_TRUE(options.IsValid(&error)) << error;
  options.fit_gate = -1.0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "ego_velocity.fit_gate must be > 0 m/s, is -1");
  options = EgoVelocityOptions();
  options.keep_gate = 0.2;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_THAT(error, HasSubstr("ego_velocity.keep_gate must be >= ego_velocity.fit_gate"));
}

}  // namespace
}  // namespace radive
