// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The factors of the ICP family.

#include <gtest/gtest.h>

#include <cmath>

#include "radive/factors/doppler_motion_factor.h"
#include "radive/factors/gicp_factor.h"
#include "radive/factors/point_to_plane_factor.h"
#include "radive/factors/point_to_point_factor.h"
#include "radive/geometry/sqrt_information.h"
#include "radive/util/angle_units.h"
#include "tests/factors/pose_factor_test_utils.h"

namespace radive {
namespace {

using testing::CostPtr;
using testing::ExpectAutodiffMatchesNumeric;
using testing::Residuals;

// A quarter turn to the left and 10 m ahead: (1, 2, 3) in the radar frame is at (8, 1, 3).
const Rigid3 kQuarterTurn{QuaternionFromRotationVector({0.0, 0.0, kPi / 2}), {10.0, 0.0, 0.0}};

TEST(PointToPointFactor, IsZeroOnTheNeighbour) {
  const CostPtr cost(PointToPointFactor::Create({1.0, 2.0, 3.0}, {8.0, 1.0, 3.0}, 0.5));
  EXPECT_LT(Residuals(cost, kQuarterTurn).norm(), 1e-14);
}

TEST(PointToPointFactor, ResidualIsInStandardDeviations) {
  const CostPtr cost(PointToPointFactor::Create({1.0, 2.0, 3.0}, {7.0, 2.0, 2.5}, 0.5));
  const Eigen::Vector3d expected(2.0, -2.0, 1.0);  // (1, -1, 0.5) m
  EXPECT_LT((Residuals(cost, kQuarterTurn) - expected).norm(), 1e-13);
}

TEST(PointToPointFactor, AutodiffMatchesNumeric) {
  ExpectAutodiffMatchesNumeric(
      CostPtr(PointToPointFactor::Create({1.0, 2.0, 3.0}, {-4.0, 5.0, 6.0}, 0.5)));
}

TEST(PointToPlaneFactor, IsZeroAnywhereInThePlane) {
  // The plane x = 8, through a point that is far along it.
  const CostPtr cost(
      PointToPlaneFactor::Create({1.0, 2.0, 3.0}, {8.0, 50.0, -7.0}, {-1.0, 0.0, 0.0}, 0.5));
  EXPECT_NEAR(Residuals(cost, kQuarterTurn)[0], 0.0, 1e-13);
}

// (1, -1, 0.5) m off, normal (0.6, 0.8, 0): 0.6 - 0.8 = -0.2 m, of 0.1 m each.
TEST(PointToPlaneFactor, ResidualIsInStandardDeviations) {
  const CostPtr cost(
      PointToPlaneFactor::Create({1.0, 2.0, 3.0}, {7.0, 2.0, 2.5}, {0.6, 0.8, 0.0}, 0.1));
  EXPECT_NEAR(Residuals(cost, kQuarterTurn)[0], -2.0, 1e-12);
}

TEST(PointToPlaneFactor, AutodiffMatchesNumeric) {
  ExpectAutodiffMatchesNumeric(CostPtr(
      PointToPlaneFactor::Create({1.0, 2.0, 3.0}, {-4.0, 5.0, 6.0}, {0.48, 0.6, 0.64}, 0.5)));
}

TEST(GicpFactor, IsZeroOnTheNeighbour) {
  const CostPtr cost(
      GicpFactor::Create({1.0, 2.0, 3.0}, {8.0, 1.0, 3.0}, Eigen::Matrix3d::Identity()));
  EXPECT_LT(Residuals(cost, kQuarterTurn).norm(), 1e-14);
}

// Covariance L L^T with L = [2 0 0; 1 3 0; -1 2 4]: the gap (2, 7, 1) m is L (1, 2, -0.5).
TEST(GicpFactor, ResidualIsInStandardDeviations) {
  Eigen::Matrix3d covariance;
  covariance << 4.0, 2.0, -2.0, 2.0, 10.0, 5.0, -2.0, 5.0, 21.0;
  const CostPtr cost(
      GicpFactor::Create({1.0, 2.0, 3.0}, {6.0, -6.0, 2.0}, SqrtInformation<3>(covariance)));
  const Eigen::Vector3d expected(1.0, 2.0, -0.5);
  EXPECT_LT((Residuals(cost, kQuarterTurn) - expected).norm(), 1e-13);
}

TEST(GicpFactor, AutodiffMatchesNumeric) {
  Eigen::Matrix3d covariance;
  covariance << 4.0, 2.0, -2.0, 2.0, 10.0, 5.0, -2.0, 5.0, 21.0;
  ExpectAutodiffMatchesNumeric(CostPtr(
      GicpFactor::Create({1.0, 2.0, 3.0}, {-4.0, 5.0, 6.0}, SqrtInformation<3>(covariance))));
}

// From the origin, heading along y, 2 m along y in 0.2 s: 10 m/s ahead. A return straight ahead
// comes nearer by 10 m/s, one at 60 degrees by 5 m/s.
TEST(DopplerMotionFactor, IsZeroForTheMotionThatWasDriven) {
  const Rigid3 T0{QuaternionFromRotationVector({0.0, 0.0, kPi / 2}), {0.0, 0.0, 0.0}};
  const Rigid3 T1{T0.rotation, {0.0, 2.0, 0.0}};
  const CostPtr ahead(DopplerMotionFactor::Create(T0, 0.2, {1.0, 0.0, 0.0}, -10.0, 0.1));
  EXPECT_NEAR(Residuals(ahead, T1)[0], 0.0, 1e-12);
  const Eigen::Vector3d aside(0.5, std::sqrt(0.75), 0.0);
  const CostPtr sixty(DopplerMotionFactor::Create(T0, 0.2, aside, -5.0, 0.1));
  EXPECT_NEAR(Residuals(sixty, T1)[0], 0.0, 1e-12);
}

// On a circle of radius 10 m by 0.2 rad in 0.1 s: the chord 2 * 10 sin(0.1) lies half-way between
// both headings, so that the velocity is straight ahead in the radar's frame.
TEST(DopplerMotionFactor, VelocityIsThatOfTheArc) {
  const Rigid3 T1{QuaternionFromRotationVector({0.0, 0.0, 0.2}),
                  {10.0 * std::sin(0.2), 10.0 * (1.0 - std::cos(0.2)), 0.0}};
  const double speed = 20.0 * std::sin(0.1) / 0.1;
  const CostPtr ahead(DopplerMotionFactor::Create(Rigid3(), 0.1, {1.0, 0.0, 0.0}, -speed, 0.1));
  EXPECT_NEAR(Residuals(ahead, T1)[0], 0.0, 1e-11);
  const CostPtr left(DopplerMotionFactor::Create(Rigid3(), 0.1, {0.0, 1.0, 0.0}, 0.0, 0.1));
  EXPECT_NEAR(Residuals(left, T1)[0], 0.0, 1e-11);
}

// Measured 0.3 m/s faster than driven towards it: three standard deviations of 0.1 m/s.
TEST(DopplerMotionFactor, ResidualIsInStandardDeviations) {
  const Rigid3 T1{Eigen::Quaterniond::Identity(), {1.0, 0.0, 0.0}};
  const CostPtr cost(DopplerMotionFactor::Create(Rigid3(), 0.1, {1.0, 0.0, 0.0}, -10.3, 0.1));
  EXPECT_NEAR(Residuals(cost, T1)[0], -3.0, 1e-12);
}

TEST(DopplerMotionFactor, AutodiffMatchesNumeric) {
  const Rigid3 T0{QuaternionFromRotationVector({0.1, -0.2, 0.3}), {0.5, 0.2, -0.1}};
  ExpectAutodiffMatchesNumeric(
      CostPtr(DopplerMotionFactor::Create(T0, 0.5, {0.48, 0.6, 0.64}, -3.0, 0.5)));
}

}  // namespace
}  // namespace radive
