// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/vehicle_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace radive {
namespace {

constexpr double kMaxSpeed = 12.0;  // [m/s]

class VehicleMotionTest : public ::testing::Test {
 protected:
  const StreetPath path_{270.0, 113.0, 60.0};
  const Terrain flat_;
  VehicleMotion motion_{path_, flat_, VehicleMotion::Options(), /*seed=*/5};
};

// Central differences of the poses.
void ExpectVelocitiesAreDerivatives(VehicleMotion* motion) {
  constexpr double kStep = 1e-5;
  for (double time = 0.505; time < 120.0; time += 0.733) {
    const VehicleMotion::BodyState before = motion->BodyAt(time - kStep);
    const VehicleMotion::BodyState at = motion->BodyAt(time);
    const VehicleMotion::BodyState after = motion->BodyAt(time + kStep);
    const Eigen::Vector3d v_world =
        (after.T_world_body.translation - before.T_world_body.translation) / (2.0 * kStep);
    EXPECT_LT((at.T_world_body.rotation * at.v_body - v_world).norm(), 1e-5) << "t = " << time;
    const Eigen::Vector3d omega =
        RotationVector(before.T_world_body.rotation.conjugate() * after.T_world_body.rotation) /
        (2.0 * kStep);
    EXPECT_LT((at.omega_body - omega).norm(), 2e-5) << "t = " << time;
  }
}

TEST_F(VehicleMotionTest, VelocitiesAreDerivativesOfThePose) {
  ExpectVelocitiesAreDerivatives(&motion_);
}

TEST(VehicleMotion, AlsoOfAHandcartOnSlopes) {
  const StreetPath path(80.0, 34.0, 22.0);
  const Terrain hills({{2.0, {0.05, 0.0}, 0.3}, {1.0, {-0.03, 0.04}, 1.0}});
  VehicleMotion::Options options;
  options.style = StyleOf(VehicleType::kHandcart);
  options.max_speed = 1.4;
  VehicleMotion motion(path, hills, options, 5);
  ExpectVelocitiesAreDerivatives(&motion);
}

// On a slope the body lies flat on the ground: its z axis is the normal, and it moves along x.
TEST(VehicleMotion, FollowsTheGround) {
  const StreetPath path(270.0, 113.0, 60.0);
  const Terrain hills({{2.0, {0.05, 0.0}, 0.3}, {1.0, {-0.03, 0.04}, 1.0}});
  VehicleMotion::Options options;
  options.wobble = 0.0;
  VehicleMotion motion(path, hills, options, 5);
  double steepest = 0.0;
  for (double time = 0.0; time < 100.0; time += 1.7) {
    const VehicleMotion::BodyState body = motion.BodyAt(time);
    const Eigen::Vector2d at = body.T_world_body.translation.head<2>();
    EXPECT_NEAR(body.T_world_body.translation.z(), hills.Height(at), 1e-12);
    const Eigen::Vector3d up = body.T_world_body.rotation * Eigen::Vector3d::UnitZ();
    EXPECT_LT((up - hills.Normal(at)).norm(), 1e-12);
    EXPECT_LT(body.v_body.tail<2>().norm(), 1e-12);
    steepest = std::max(steepest, std::acos(up.z()));
  }
  EXPECT_GT(steepest, 0.08);
}

// Every 30 m on average: in 200 m of driving six or seven stops of four seconds.
TEST(VehicleMotion, StopsAndGoes) {
  const StreetPath path(270.0, 113.0, 60.0);
  const Terrain flat;
  VehicleMotion::Options options;
  options.max_speed = 6.0;
  options.stop_distance = 30.0;
  VehicleMotion motion(path, flat, options, 5);
  double standing = 0.0, time = 10.0;
  for (; motion.TravelAt(time).s < 200.0 && time < 300.0; time += 0.01) {
    if (motion.TravelAt(time).speed == 0.0) standing += 0.01;
  }
  EXPECT_GT(standing, 4 * 4.0);
  EXPECT_LT(standing, 9 * 4.0);
  EXPECT_LT(time, 150.0);
}

// Below 1.5 m/s and never smooth: it turns by degrees a second, a few times a second.
TEST(VehicleMotion, TheHandcartShakes) {
  const StreetPath path(80.0, 34.0, 22.0);
  const Terrain flat;
  VehicleMotion::Options options;
  options.style = StyleOf(VehicleType::kHandcart);
  options.max_speed = 1.4;
  VehicleMotion motion(path, flat, options, 5);
  double sum = 0.0;
  int count = 0, turns = 0;
  double last = 0.0;
  for (double time = 5.0; time < 35.0; time += 0.01) {
    const VehicleMotion::BodyState body = motion.BodyAt(time);
    EXPECT_LT(body.v_body.norm(), 1.6);
    const double rate = body.omega_body.y();
    sum += rate * rate;
    if (rate * last < 0.0) ++turns;
    last = rate;
    ++count;
  }
  EXPECT_GT(std::sqrt(sum / count), 0.05);  // 3 deg/s
  EXPECT_GT(turns, 30);                     // over 30 s
}

TEST_F(VehicleMotionTest, SpeedAndAccelerationsStayWithinLimits) {
  double fastest = 0.0;
  for (double time = 0.0; time < 300.0; time += 0.05) {
    const VehicleMotion::Travel travel = motion_.TravelAt(time);
    EXPECT_GE(travel.speed, 0.0);
    EXPECT_LE(travel.speed, kMaxSpeed + 0.05) << "t = " << time;
    EXPECT_LE(std::abs(travel.acceleration), 3.1) << "t = " << time;
    const double lateral = travel.speed * travel.speed * path_.At(travel.s).curvature;
    EXPECT_LE(lateral, 2.6) << "t = " << time;
    fastest = std::max(fastest, travel.speed);
  }
  EXPECT_GT(fastest, 0.9 * kMaxSpeed);
}

// It stands 1.5 s at the start and about 4 s at the traffic light of each lap.
TEST_F(VehicleMotionTest, StandsAtTheStartAndOnceALap) {
  double standing_at_start = 0.0, standing_later = 0.0, lap_time = 0.0;
  for (double time = 0.0; lap_time == 0.0 && time < 300.0; time += 0.01) {
    const VehicleMotion::Travel travel = motion_.TravelAt(time);
    if (travel.speed == 0.0) (time < 10.0 ? standing_at_start : standing_later) += 0.01;
    if (travel.s >= path_.length()) lap_time = time;
  }
  EXPECT_NEAR(standing_at_start, 1.5, 0.05);
  EXPECT_NEAR(standing_later, 4.0, 0.1);
  EXPECT_GT(lap_time, path_.length() / kMaxSpeed);
  EXPECT_LT(lap_time, 150.0);
}

TEST_F(VehicleMotionTest, PoseRepeatsAfterALap) {
  double low = 60.0, high = 200.0;
  while (high - low > 1e-12 * high) {
    const double middle = 0.5 * (low + high);
    (motion_.TravelAt(middle).s < path_.length() ? low : high) = middle;
  }
  const Rigid3 start = motion_.BodyAt(0.0).T_world_body;
  const Rigid3 end = motion_.BodyAt(high).T_world_body;
  EXPECT_LT((start.translation - end.translation).norm(), 1e-8);
  EXPECT_LT(RotationVector(start.rotation.conjugate() * end.rotation).norm(), 1e-8);
}

TEST(VehicleMotion, WithoutWobbleTheDriveIsPlane) {
  const StreetPath path(270.0, 113.0, 60.0);
  const Terrain flat;
  VehicleMotion::Options options;
  options.wobble = 0.0;
  VehicleMotion motion(path, flat, options, /*seed=*/5);
  for (double time = 0.0; time < 60.0; time += 1.7) {
    const VehicleMotion::BodyState body = motion.BodyAt(time);
    EXPECT_EQ(body.T_world_body.translation.z(), 0.0);
    EXPECT_NEAR(body.v_body.y(), 0.0, 1e-12);  // the rear axle does not slip
    EXPECT_NEAR(body.v_body.x(), motion.TravelAt(time).speed, 1e-12);
    EXPECT_EQ(body.omega_body.head<2>().norm(), 0.0);
  }
}

}  // namespace
}  // namespace radive
