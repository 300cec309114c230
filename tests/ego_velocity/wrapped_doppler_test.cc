// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "radive/ego_velocity/ego_velocity_estimator.h"
#include "radive/ego_velocity/velocity_discrepancy.h"
#include "radive/odometry/odometry.h"
#include "radive/sensor/doppler_wrap.h"
#include "tests/ego_velocity/made_returns.h"
#include "tests/simulated_drive.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::kTenthSecond;

constexpr double kSpan = 3.866;  // K-Radar's [m/s]
TEST(WrapDoppler, GivesTheNearestToZero) {
  EXPECT_NEAR(WrapDoppler(5.0, 4.0), 1.0, 1e-15);
  EXPECT_NEAR(WrapDoppler(-3.0, 4.0), 1.0, 1e-15);
  EXPECT_NEAR(WrapDoppler(1.5, 4.0), 1.5, 1e-15);
  EXPECT_EQ(WrapDoppler(123.0, 0.0), 123.0);
}

// At 10 m/s ahead a return straight ahead has -10; measured with a span of 4 that is -2 or 2.
TEST(VelocityDiscrepancy, OfDopplerThatWrapsIsToTheNearestMultiple) {
  RadarReturn entry;
  entry.position = {20, 0, 0};
  entry.doppler = 1.5;
  EXPECT_NEAR(VelocityDiscrepancy(entry, {10, 0, 0}, 4.0), 0.5, 1e-12);
  EXPECT_NEAR(VelocityDiscrepancy(entry, {10, 0, 0}), 11.5, 1e-12);
  EXPECT_NEAR(DiscrepancyWeights({entry}, {10, 0, 0}, 0.5, 4.0)[0], std::exp(-1.0), 1e-12);
  EXPECT_TRUE(KeepMask({entry}, {10, 0, 0}, 0.6, 0.0, 4.0)[0]);
  EXPECT_FALSE(KeepMask({entry}, {10, 0, 0}, 0.4, 0.0, 4.0)[0]);
}

void Wrap(std::vector<RadarReturn>* returns) {
  for (RadarReturn& entry : *returns) entry.doppler = WrapDoppler(entry.doppler, kSpan);
}

SensorOptions Wrapping() {
  SensorOptions sensor;
  sensor.doppler_span = kSpan;
  return sensor;
}

// A fifth of the returns belongs to a car that is overtaken.
std::vector<RadarReturn> Street(const Eigen::Vector3d& v_radar, Random* random) {
  std::vector<RadarReturn> returns = testing::MakeStaticReturns(200, v_radar, {}, random);
  const std::vector<RadarReturn> car = testing::MakeReturns(50, v_radar, 0.5 * v_radar, {}, random);
  returns.insert(returns.end(), car.begin(), car.end());
  Wrap(&returns);
  return returns;
}

// From standing to 24 m/s, six spans, and back, while the radar sways to both sides.
TEST(WrappedDoppler, AcceleratingThroughSeveralSpansKeepsTheTrueVelocity) {
  Random random(5);
  EgoVelocityEstimator estimator({}, Wrapping());
  for (int k = 0; k < 160; ++k) {
    const double forward = k < 80 ? 0.3 * k : 0.3 * (160 - k);
    const Eigen::Vector3d truth(forward, 0.8 * std::sin(0.1 * k), 0.0);
    const EgoVelocity fit = estimator.Estimate(Street(truth, &random), false, k * kTenthSecond);
    ASSERT_TRUE(fit.valid) << k << ": " << fit.reason;
    EXPECT_LT((fit.v_radar - truth).head<2>().norm(), 0.15) << k;
    EXPECT_EQ(fit.is_standing, k == 0) << k;
    EXPECT_GT(fit.num_inliers, 150) << k;
  }
}

TEST(WrappedDoppler, TheFirstScanFindsTheBranch) {
  Random random(6);
  for (const double forward : {-9.0, -1.0, 0.0, 1.9, 3.9, 7.0, 13.5, 21.0, 33.0}) {
    const Eigen::Vector3d truth(forward, 0.4, 0.0);
    EgoVelocityEstimator estimator({}, Wrapping());
    const EgoVelocity fit = estimator.Estimate(Street(truth, &random), false, 0);
    ASSERT_TRUE(fit.valid) << forward << ": " << fit.reason;
    EXPECT_LT((fit.v_radar - truth).head<2>().norm(), 0.15) << forward;
  }
}

// After two seconds without a velocity several branches lie within the gate.
TEST(WrappedDoppler, FindsTheBranchAgainAfterAGap) {
  Random random(7);
  EgoVelocityEstimator estimator({}, Wrapping());
  ASSERT_TRUE(estimator.Estimate(Street({6, 0, 0}, &random), false, 0).valid);
  const EgoVelocity fit = estimator.Estimate(Street({16, 0, 0}, &random), false, 20 * kTenthSecond);
  ASSERT_TRUE(fit.valid) << fit.reason;
  EXPECT_NEAR(fit.v_radar.x(), 16.0, 0.15);
}

// The radar looks to the left, so it sees the vehicle drive to its right.
TEST(WrappedDoppler, KnowsWhereTheVehicleGoes) {
  Random random(8);
  SensorOptions sensor = Wrapping();
  sensor.mount_yaw = 1.5707963267948966;
  EgoVelocityEstimator estimator({}, sensor);
  const EgoVelocity fit = estimator.Estimate(Street({0, -15, 0}, &random), false, 0);
  ASSERT_TRUE(fit.valid) << fit.reason;
  EXPECT_NEAR(fit.v_radar.y(), -15.0, 0.15);
}

// All within 8 degrees of ahead: every multiple of the span fits as well.
TEST(WrappedDoppler, ANarrowViewLeavesItOpenAndSaysSo) {
  Random random(9);
  testing::ReturnsModel model;
  model.half_azimuth = 0.14;
  std::vector<RadarReturn> returns = testing::MakeStaticReturns(200, {10, 0, 0}, model, &random);
  Wrap(&returns);
  EgoVelocityEstimator estimator({}, Wrapping());
  const EgoVelocity fit = estimator.Estimate(returns, false, 0);
  EXPECT_FALSE(fit.valid);
  EXPECT_THAT(fit.reason, HasSubstr("which multiple of its span"));
}

// Without wrapping, the span of a Doppler that never comes near it changes nothing that counts.
TEST(WrappedDoppler, AWideSpanGivesWhatNoneGives) {
  Random random(10);
  SensorOptions wide;
  wide.doppler_span = 400.0;
  const std::vector<RadarReturn> returns =
      testing::MakeStaticReturns(200, {12, 0.5, 0}, {}, &random);
  const EgoVelocity with = EgoVelocityEstimator({}, wide).Estimate(returns, false, 0);
  const EgoVelocity without = EgoVelocityEstimator({}, {}).Estimate(returns, false, 0);
  ASSERT_TRUE(with.valid && without.valid) << with.reason << without.reason;
  EXPECT_LT((with.v_radar - without.v_radar).norm(), 1e-9);
  EXPECT_EQ(with.num_inliers, without.num_inliers);
}

TEST(WrappedDoppler, ASimulatedDriveIsWhatItIsWithoutWrapping) {
  testing::Drive drive = testing::SimulateDrive(testing::Scenario("street_sparse", 400));
  OdometryOptions options = testing::OptionsFor(drive.simulation);
  const testing::DriveErrors plain =
      testing::Compare(drive, testing::RunOdometry(options, drive.scans));
  for (RadarScan& scan : drive.scans) Wrap(&scan.returns);
  options.sensor.doppler_span = kSpan;
  const std::vector<OdometryResult> results = testing::RunOdometry(options, drive.scans);
  const testing::DriveErrors wrapped = testing::Compare(drive, results);
  EXPECT_GT(plain.length, 80.0);
  EXPECT_LT(wrapped.rmse, 0.01 * plain.length);
  EXPECT_LT(wrapped.rmse, 1.5 * plain.rmse + 0.05) << plain.rmse;
  EXPECT_TRUE(results.back().ego_velocity.valid) << results.back().ego_velocity.reason;
}

// While the Doppler leaves the velocity open, registration goes on without it.
TEST(WrappedDoppler, ScansWithoutAVelocityAreRegisteredAllTheSame) {
  testing::Drive drive = testing::SimulateDrive(testing::Scenario("street_dense", 30));
  for (RadarScan& scan : drive.scans) {
    Random random(11);
    for (RadarReturn& entry : scan.returns) entry.doppler = random.Uniform(-1.9, 1.9);
  }
  OdometryOptions options = testing::OptionsFor(drive.simulation);
  options.sensor.doppler_span = kSpan;
  const std::vector<OdometryResult> results = testing::RunOdometry(options, drive.scans);
  EXPECT_FALSE(results[1].ego_velocity.valid);
  EXPECT_GT(testing::Compare(drive, results).num_registered, 25);
}

}  // namespace
}  // namespace radive
