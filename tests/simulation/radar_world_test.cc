// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/radar_world.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "radive/util/random.h"

namespace radive {
namespace {

const Eigen::Vector3d kOrigin(0.0, 0.0, 0.6);

// A wall 3 m high across the x axis at x = 10 m.
RadarWorld OneWall() { return {{{{10.0, -5.0}, {10.0, 5.0}, 3.0, Surface::kFacade}}, {}}; }

TEST(RadarWorld, RayMeetsTheWall) {
  const auto hit = OneWall().Cast(kOrigin, Eigen::Vector3d::UnitX(), 100.0, {});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 10.0, 1e-12);
  EXPECT_EQ(hit->surface, Surface::kFacade);
  EXPECT_NEAR((hit->normal + Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-12);
}

// 3-4-5: the wall is met 12.5 m along the ray, at y = 7.5 m where it has ended already.
TEST(RadarWorld, RayPassesBesideTheWall) {
  EXPECT_FALSE(OneWall().Cast(kOrigin, {0.8, 0.6, 0.0}, 100.0, {}));
}

TEST(RadarWorld, RayPassesAboveTheWall) {
  const RadarWorld world = OneWall();
  const auto at_height = [](double z) { return Eigen::Vector3d(10.0, 0.0, z - 0.6).normalized(); };
  EXPECT_TRUE(world.Cast(kOrigin, at_height(2.99), 100.0, {}));
  EXPECT_FALSE(world.Cast(kOrigin, at_height(3.01), 100.0, {}));
}

TEST(RadarWorld, NothingBeyondTheMaximumDistance) {
  EXPECT_FALSE(OneWall().Cast(kOrigin, Eigen::Vector3d::UnitX(), 9.99, {}));
}

// 0.6 m above the ground and 3-4-5 downwards: 1 m along the ray.
TEST(RadarWorld, RayMeetsTheGround) {
  const auto hit = OneWall().Cast(kOrigin, {0.8, 0.0, -0.6}, 100.0, {});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 1.0, 1e-12);
  EXPECT_EQ(hit->surface, Surface::kGround);
}

// A car across the ray: its side is half a width nearer than its centre, and its nose, 2.2 m from
// the centre, turns with the yaw rate.
TEST(RadarWorld, MovingCarHidesTheWallAndHasItsVelocity) {
  MovingCar car;
  car.center = {6.0, -2.0};
  car.heading = std::acos(0.0);
  car.velocity = {0.0, 8.0};
  car.yaw_rate = 0.5;
  const auto hit = OneWall().Cast(kOrigin, Eigen::Vector3d::UnitX(), 100.0, {car});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->surface, Surface::kMovingCar);
  EXPECT_NEAR(hit->distance, 6.0 - 0.9, 1e-12);
  // velocity + yaw_rate x arm, arm = (-0.9, 2.0).
  EXPECT_NEAR(hit->velocity.x(), -0.5 * 2.0, 1e-12);
  EXPECT_NEAR(hit->velocity.y(), 8.0 + 0.5 * -0.9, 1e-12);
}

// The grid may only make it faster: the same answer as trying every wall.
TEST(RadarWorld, GridAgreesWithBruteForce) {
  Random random(3);
  std::vector<WallSegment> walls;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector2d a(random.Uniform(-80, 80), random.Uniform(-60, 60));
    const Eigen::Vector2d b = a + Eigen::Vector2d(random.Uniform(-9, 9), random.Uniform(-9, 9));
    walls.push_back({a, b, random.Uniform(0.5, 6.0), Surface::kFacade});
  }
  const RadarWorld world(walls, {});
  int hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d origin(random.Uniform(-120, 120), random.Uniform(-100, 100), 0.6);
    const double azimuth = random.Uniform(-3.2, 3.2);
    const Eigen::Vector3d direction =
        Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), random.Uniform(0.0, 0.1))
            .normalized();
    double expected = 150.0;
    for (const WallSegment& wall : walls) {
      Eigen::Matrix2d m;
      m << direction.head<2>(), wall.a - wall.b;
      const Eigen::Vector2d solution = m.inverse() * (wall.a - origin.head<2>());
      const double z = origin.z() + solution.x() * direction.z();
      if (solution.y() < 0.0 || solution.y() > 1.0 || solution.x() <= 0.0 || z > wall.height) {
        continue;
      }
      expected = std::min(expected, solution.x());
    }
    const std::optional<RayHit> hit = world.Cast(origin, direction, 150.0, {});
    EXPECT_NEAR(hit ? hit->distance : 150.0, expected, 1e-6) << "ray " << i;
    if (hit) ++hits;
  }
  EXPECT_GT(hits, 1000);
}

TEST(RadarWorld, RayPassesBelowAHangingWall) {
  const RadarWorld world({{{10.0, -5.0}, {10.0, 5.0}, 3.0, Surface::kVegetation, 2.0}}, {});
  const auto at_height = [](double z) { return Eigen::Vector3d(10.0, 0.0, z - 0.6).normalized(); };
  EXPECT_FALSE(world.Cast(kOrigin, at_height(1.99), 100.0, {}));
  EXPECT_TRUE(world.Cast(kOrigin, at_height(2.01), 100.0, {}));
}

// A roof 3 m up, 3-4-5: 4 m along the ray from 0.6 m.
TEST(RadarWorld, RayMeetsTheCeiling) {
  const RadarWorld world({}, {}, Terrain(), 3.0);
  const auto hit = world.Cast(kOrigin, {0.8, 0.0, 0.6}, 100.0, {});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 4.0, 1e-12);
  EXPECT_EQ(hit->surface, Surface::kConcrete);
  EXPECT_EQ(hit->normal, Eigen::Vector3d(0.0, 0.0, -1.0));
  EXPECT_NEAR(world.DistanceToSurface({5.0, 5.0, 2.5}), 0.5, 1e-12);
}

// A car on a hill is met at its own height, and rises with its climb.
TEST(RadarWorld, CarsStandOnTheGround) {
  MovingCar car;
  car.center = {10.0, 0.0};
  car.ground = 5.0;
  car.climb = 0.5;
  const RadarWorld world({}, {}, Terrain({{5.0, {0.0, 0.0}, std::asin(1.0)}}));  // z = 5
  const auto hit = world.Cast({0.0, 0.0, 6.0}, Eigen::Vector3d::UnitX(), 100.0, {car});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->distance, 10.0 - 2.2, 1e-12);
  EXPECT_EQ(hit->velocity.z(), 0.5);
  EXPECT_FALSE(world.Cast({0.0, 0.0, 6.6}, Eigen::Vector3d::UnitX(), 100.0, {car}));
}

TEST(RadarWorld, DistanceToSurface) {
  const RadarWorld world = OneWall();
  EXPECT_NEAR(world.DistanceToSurface({7.0, 0.0, 5.0}), 3.6055512754639896, 1e-12);  // over the top
  EXPECT_NEAR(world.DistanceToSurface({10.5, 2.0, 2.0}), 0.5, 1e-12);
  EXPECT_NEAR(world.DistanceToSurface({0.0, 0.0, 0.25}), 0.25, 1e-12);  // the ground
}

}  // namespace
}  // namespace radive
