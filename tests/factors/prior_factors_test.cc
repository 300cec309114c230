// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The factors that hold what is known of a pose before its scan is looked at.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "radive/factors/attitude_height_prior_factor.h"
#include "radive/factors/displacement_prior_factor.h"
#include "radive/factors/no_slip_factor.h"
#include "radive/factors/rotation_prior_factor.h"
#include "radive/factors/translation_prior_factor.h"
#include "radive/geometry/sqrt_information.h"
#include "radive/util/angle_units.h"
#include "tests/factors/pose_factor_test_utils.h"
#include "tests/synthetic_scene.h"

namespace radive {
namespace {

using testing::CostPtr;
using testing::ExpectAutodiffMatchesNumeric;
using testing::Residuals;

Eigen::Matrix3d FullCovariance() {
  Eigen::Matrix3d covariance;  // of L = [2 0 0; 1 3 0; -1 2 4]
  covariance << 4.0, 2.0, -2.0, 2.0, 10.0, 5.0, -2.0, 5.0, 21.0;
  return covariance;
}

TEST(TranslationPriorFactor, IsZeroAtThePrediction) {
  const CostPtr cost(TranslationPriorFactor::Create({1.0, 2.0, 3.0}, Eigen::Matrix3d::Identity()));
  const Rigid3 T{QuaternionFromRotationVector({0.5, 0.1, 2.0}), {1.0, 2.0, 3.0}};
  EXPECT_EQ(Residuals(cost, T).norm(), 0.0);
}

// e = (2, 7, 1) = L (1, 2, -0.5): one, two and minus half a standard deviation.
TEST(TranslationPriorFactor, ResidualIsInStandardDeviations) {
  const CostPtr cost(
      TranslationPriorFactor::Create({1.0, 2.0, 3.0}, SqrtInformation<3>(FullCovariance())));
  const Rigid3 T{Eigen::Quaterniond::Identity(), {3.0, 9.0, 4.0}};
  EXPECT_LT((Residuals(cost, T) - Eigen::Vector3d(1.0, 2.0, -0.5)).norm(), 1e-14);
}

// lambda/2 |t - t_init|^2 with lambda 4 and 3 m: 18.
TEST(TranslationPriorFactor, IsThePapersLowSpeedPrior) {
  const CostPtr cost(TranslationPriorFactor::Create(
      {0.0, 0.0, 0.0}, SqrtInformation<3>(Eigen::Matrix3d::Identity() / 4.0)));
  const Rigid3 T{Eigen::Quaterniond::Identity(), {2.0, -1.0, 2.0}};
  EXPECT_NEAR(0.5 * Residuals(cost, T).squaredNorm(), 18.0, 1e-12);
}

TEST(TranslationPriorFactor, AutodiffMatchesNumeric) {
  ExpectAutodiffMatchesNumeric(CostPtr(
      TranslationPriorFactor::Create({1.0, 2.0, 3.0}, SqrtInformation<3>(FullCovariance()))));
}

TEST(RotationPriorFactor, IsZeroAtThePredictionOfEitherSign) {
  const Eigen::Quaterniond q = QuaternionFromRotationVector({0.3, -0.2, 2.5});
  const CostPtr cost(RotationPriorFactor::Create(q, Eigen::Matrix3d::Identity()));
  EXPECT_LT(Residuals(cost, {q, {5.0, 6.0, 7.0}}).norm(), 1e-15);
  EXPECT_LT(Residuals(cost, {Eigen::Quaterniond(-q.coeffs()), {0.0, 0.0, 0.0}}).norm(), 1e-15);
}

// A small turn about the z axis of the submap, whatever the orientation: the covariance is that of
// the rotation vector in the submap frame. Three milliradian at 1 mrad are three.
TEST(RotationPriorFactor, ResidualIsInStandardDeviationsInTheSubmapFrame) {
  const Eigen::Quaterniond q = QuaternionFromRotationVector({0.3, -0.2, 2.5});
  const Eigen::Vector3d variances(1e-4, 1e-4, 1e-6);
  const CostPtr cost(
      RotationPriorFactor::Create(q, SqrtInformation<3>(Eigen::Matrix3d(variances.asDiagonal()))));
  const Eigen::Quaterniond turned = QuaternionFromRotationVector({0.0, 0.0, 0.003}) * q;
  EXPECT_LT(
      (Residuals(cost, {turned, Eigen::Vector3d::Zero()}) - Eigen::Vector3d(0.0, 0.0, 3.0)).norm(),
      1e-5);
  // The opposite sign of the same quaternion.
  const Eigen::Quaterniond opposite(-turned.coeffs());
  EXPECT_LT((Residuals(cost, {opposite, Eigen::Vector3d::Zero()}) - Eigen::Vector3d(0.0, 0.0, 3.0))
                .norm(),
            1e-5);
}

TEST(RotationPriorFactor, WhitensFullCovariances) {
  const CostPtr cost(RotationPriorFactor::Create(Eigen::Quaterniond::Identity(),
                                                 SqrtInformation<3>(1e-6 * FullCovariance())));
  const Rigid3 T{QuaternionFromRotationVector({0.002, 0.007, 0.001}), {0.0, 0.0, 0.0}};
  EXPECT_LT((Residuals(cost, T) - Eigen::Vector3d(1.0, 2.0, -0.5)).norm(), 1e-4);
}

TEST(RotationPriorFactor, AutodiffMatchesNumeric) {
  ExpectAutodiffMatchesNumeric(CostPtr(RotationPriorFactor::Create(
      QuaternionFromRotationVector({0.1, 0.2, -0.3}), SqrtInformation<3>(FullCovariance()))));
}

// A level car with a radar that looks 45 degrees to the left and is pitched: up_radar is no axis.
TEST(AttitudeHeightPriorFactor, IsZeroForALevelCarAtAnyHeading) {
  const Eigen::Quaterniond q_vehicle_radar = QuaternionFromRotationVector({0.0, 0.0, 0.25 * kPi}) *
                                             QuaternionFromRotationVector({0.0, 0.1, 0.0});
  const Eigen::Vector3d up_radar = q_vehicle_radar.conjugate() * Eigen::Vector3d::UnitZ();
  const CostPtr cost(AttitudeHeightPriorFactor::Create(
      up_radar, Eigen::Vector3d::UnitZ(), {0.0, 0.0, 0.5}, 0.01, 0.1));
  for (const double heading : {0.0, 1.0, 3.0, -2.0}) {
    const Rigid3 T{QuaternionFromRotationVector({0.0, 0.0, heading}) * q_vehicle_radar,
                   {7.0, -30.0, 0.5}};
    EXPECT_LT(Residuals(cost, T).norm(), 1e-13);
  }
}

// 20 mrad of tilt at 10 mrad, 0.3 m of height at 0.1 m.
TEST(AttitudeHeightPriorFactor, ResidualIsInStandardDeviations) {
  const CostPtr cost(AttitudeHeightPriorFactor::Create(
      Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(), {0.0, 0.0, 0.5}, 0.01, 0.1));
  const Rigid3 T{QuaternionFromRotationVector({0.0, 0.0, 1.2}) *
                     QuaternionFromRotationVector({0.02 * 0.6, -0.02 * 0.8, 0.0}),
                 {9.0, 9.0, 0.8}};
  const Eigen::VectorXd residuals = Residuals(cost, T);
  EXPECT_NEAR(residuals.head<2>().norm(), 2.0, 2e-4);
  EXPECT_NEAR(residuals[2], 3.0, 1e-12);
}

// With a slanted reference axis only the part along it is height.
TEST(AttitudeHeightPriorFactor, HeightIsAlongTheReferenceAxis) {
  const Eigen::Vector3d up = Eigen::Vector3d(0.6, 0.0, 0.8);
  const CostPtr cost(AttitudeHeightPriorFactor::Create(up, up, {0.0, 0.0, 0.0}, 0.01, 0.1));
  const Rigid3 along{Eigen::Quaterniond::Identity(), {0.8, 5.0, -0.6}};
  EXPECT_NEAR(Residuals(cost, along)[2], 0.0, 1e-13);
  const Rigid3 above{Eigen::Quaterniond::Identity(), 0.2 * up};
  EXPECT_NEAR(Residuals(cost, above)[2], 2.0, 1e-13);
}

TEST(AttitudeHeightPriorFactor, AutodiffMatchesNumeric) {
  for (const Eigen::Vector3d& up : {Eigen::Vector3d(0.1, -0.2, 0.9), Eigen::Vector3d(1, 0.1, 0)}) {
    ExpectAutodiffMatchesNumeric(CostPtr(AttitudeHeightPriorFactor::Create(
        up, Eigen::Vector3d(0.0, 0.1, 1.0), {1.0, 2.0, 3.0}, 0.02, 0.1)));
  }
}

// A car that drives on a circle about (0, radius), rear axle first at the origin, heading +x. The
// radar is mounted at T_e_radar. Positive radius: to the left.
struct CircleDrive {
  double radius;  // [m]
  Rigid3 T_e_radar;

  Rigid3 RadarAt(double arc) const {
    const double psi = arc / radius;
    const Rigid3 T_world_e{QuaternionFromRotationVector({0.0, 0.0, psi}),
                           {radius * std::sin(psi), radius * (1.0 - std::cos(psi)), 0.0}};
    return T_world_e * T_e_radar;
  }
};

// 3.6 m ahead of the rear axle, 0.7 m to the left, looking 40 degrees to the left and a little up.
Rigid3 Mount() {
  return {QuaternionFromRotationVector({0.0, 0.0, 0.7}) *
              QuaternionFromRotationVector({0.0, -0.05, 0.0}),
          {3.6, 0.7, 0.5}};
}

TEST(NoSlipFactor, IsZeroOnCirclesAndStraights) {
  for (const double radius : {8.0, -15.0, 300.0, 1e9}) {
    const CircleDrive drive{radius, Mount()};
    for (const double step : {0.1, 1.5, -0.8, 6.0}) {
      const Rigid3 T_submap_radar0 = drive.RadarAt(20.0);
      const CostPtr cost(NoSlipFactor::Create(T_submap_radar0, Mount(), 0.0, 0.01));
      // At 1e9 m the position itself is lost to rounding.
      const double tolerance = std::abs(radius) > 1e6 ? 1e-4 : 1e-11;
      EXPECT_NEAR(Residuals(cost, drive.RadarAt(20.0 + step))[0], 0.0, tolerance)
          << radius << " m, step " << step;
    }
  }
}

// The mirrored mount, the mirrored lever and the mirrored turn must all be noticed.
TEST(NoSlipFactor, IsNotZeroForAWrongMountOrTurn) {
  const CircleDrive drive{10.0, Mount()};
  const Rigid3 T0 = drive.RadarAt(0.0), T1 = drive.RadarAt(1.0);
  Rigid3 behind = Mount();
  behind.translation.x() *= -1.0;
  EXPECT_GT(std::abs(Residuals(CostPtr(NoSlipFactor::Create(T0, behind, 0.0, 0.01)), T1)[0]), 10.0);
  const Rigid3 mirrored_yaw{Mount().rotation.conjugate(), Mount().translation};
  EXPECT_GT(std::abs(Residuals(CostPtr(NoSlipFactor::Create(T0, mirrored_yaw, 0.0, 0.01)), T1)[0]),
            10.0);
  const CircleDrive other_way{-10.0, Mount()};
  const Rigid3 wrong_turn{other_way.RadarAt(1.0).rotation, T1.translation};
  EXPECT_GT(
      std::abs(Residuals(CostPtr(NoSlipFactor::Create(T0, Mount(), 0.0, 0.01)), wrong_turn)[0]),
      10.0);
}

// The rear axle slides 3 cm to the left beside driving 1 m ahead: +3 at 1 cm, and 2 once 1 cm of it
// is known.
TEST(NoSlipFactor, ResidualIsInStandardDeviationsPositiveToTheLeft) {
  const Rigid3 T_e0_e1{Eigen::Quaterniond::Identity(), {1.0, 0.03, 0.2}};
  const Rigid3 T_world_e0{QuaternionFromRotationVector({0.0, 0.0, 2.0}), {30.0, 40.0, 1.0}};
  const Rigid3 T_radar0 = T_world_e0 * Mount();
  const Rigid3 T_radar1 = T_world_e0 * T_e0_e1 * Mount();
  EXPECT_NEAR(Residuals(CostPtr(NoSlipFactor::Create(T_radar0, Mount(), 0.0, 0.01)), T_radar1)[0],
              3.0,
              1e-10);
  EXPECT_NEAR(Residuals(CostPtr(NoSlipFactor::Create(T_radar0, Mount(), 0.01, 0.01)), T_radar1)[0],
              2.0,
              1e-10);
}

// A car whose rear axle drifts moves about a point `ahead` of it that does not slip: the factor is
// zero for the mount relative to that point, which is shorter by `ahead`.
TEST(NoSlipFactor, ThePointWithoutSlipLiesAheadOfTheRearAxle) {
  constexpr double kAhead = 0.8;
  Rigid3 T_slip_radar = Mount();
  T_slip_radar.translation.x() -= kAhead;
  const CircleDrive drive{12.0, T_slip_radar};
  const Rigid3 T0 = drive.RadarAt(0.0), T1 = drive.RadarAt(1.2);
  EXPECT_NEAR(
      Residuals(CostPtr(NoSlipFactor::Create(T0, T_slip_radar, 0.0, 0.01)), T1)[0], 0.0, 1e-11);
  // The rear axle itself slides outwards by kAhead times the turn: 0.8 m * 0.1 rad = 8 sigma.
  EXPECT_NEAR(Residuals(CostPtr(NoSlipFactor::Create(T0, Mount(), 0.0, 0.01)), T1)[0], -8.0, 0.02);
}

// On the circle the velocity of the radar is constant in the radar frame; the chord of an arc is
// shorter than the arc by sin(psi/2) / (psi/2), and lies along the velocity half-way.
TEST(DisplacementPriorFactor, IsZeroForTheChordOfACircle) {
  const CircleDrive drive{10.0, Mount()};
  constexpr double kArc = 1.5;
  const double half_turn = 0.5 * kArc / drive.radius;
  // Rear axle: (1, 0, 0) per metre; the radar's lever adds the turning.
  const Eigen::Vector3d v_vehicle(
      1.0 - Mount().translation.y() / drive.radius, Mount().translation.x() / drive.radius, 0.0);
  const Eigen::Vector3d displacement =
      Mount().rotation.conjugate() * v_vehicle * kArc * std::sin(half_turn) / half_turn;
  for (const double start : {0.0, 20.0}) {
    const CostPtr cost(DisplacementPriorFactor::Create(
        drive.RadarAt(start), displacement, 100.0 * Eigen::Matrix3d::Identity()));
    // The mount looks up a little: the half turn is about a slanted axis of the radar frame.
    EXPECT_LT(Residuals(cost, drive.RadarAt(start + kArc)).norm(), 1e-11);
    // The same point with the turn to the other side.
    const CircleDrive other_way{-10.0, Mount()};
    const Rigid3 wrong{other_way.RadarAt(start + kArc).rotation,
                       drive.RadarAt(start + kArc).translation};
    EXPECT_GT(Residuals(cost, wrong).norm(), 5.0);
  }
}

// Without turning: e = L (1, 2, -0.5) beyond the displacement, in the frame of the first pose.
TEST(DisplacementPriorFactor, ResidualIsInStandardDeviations) {
  const Rigid3 T0{QuaternionFromRotationVector({0.1, -0.3, 2.0}), {30.0, 40.0, 1.0}};
  const Eigen::Vector3d d(1.0, 0.2, 0.1);
  const CostPtr cost(DisplacementPriorFactor::Create(T0, d, SqrtInformation<3>(FullCovariance())));
  const Rigid3 T1 = T0 * Rigid3(Eigen::Quaterniond::Identity(), d + Eigen::Vector3d(2.0, 7.0, 1.0));
  EXPECT_LT((Residuals(cost, T1) - Eigen::Vector3d(1.0, 2.0, -0.5)).norm(), 1e-12);
  // The opposite sign of the same quaternion.
  const Rigid3 opposite{Eigen::Quaterniond(-T1.rotation.coeffs()), T1.translation};
  EXPECT_LT((Residuals(cost, opposite) - Eigen::Vector3d(1.0, 2.0, -0.5)).norm(), 1e-12);
}

TEST(DisplacementPriorFactor, AutodiffMatchesNumeric) {
  Random random(13);
  ExpectAutodiffMatchesNumeric(CostPtr(DisplacementPriorFactor::Create(
      Rigid3(), {1.0, 0.0, 0.0}, SqrtInformation<3>(FullCovariance()))));
  ExpectAutodiffMatchesNumeric(
      CostPtr(DisplacementPriorFactor::Create(testing::RandomRigid3(0.5, 2.0, &random),
                                              {1.0, 0.2, -0.1},
                                              SqrtInformation<3>(FullCovariance()))));
}

TEST(NoSlipFactor, AutodiffMatchesNumeric) {
  Random random(12);
  ExpectAutodiffMatchesNumeric(CostPtr(NoSlipFactor::Create(Rigid3(), Rigid3(), 0.0, 0.05)));
  ExpectAutodiffMatchesNumeric(
      CostPtr(NoSlipFactor::Create(testing::RandomRigid3(0.5, 2.0, &random), Mount(), 0.02, 0.05)));
}

}  // namespace
}  // namespace radive
