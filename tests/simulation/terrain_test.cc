// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/terrain.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "radive/util/random.h"

namespace radive {
namespace {

// Slopes of at most 0.15.
Terrain Hills() { return Terrain({{2.0, {0.05, 0.0}, 0.3}, {1.0, {-0.03, 0.04}, 1.0}}); }

TEST(Terrain, HeightIsThatOfTheWaves) {
  // sin(pi / 6) = 1/2 and sin(pi / 2) = 1.
  const double pi = std::acos(-1.0);
  const Terrain terrain({{2.0, {pi / 60.0, 0.0}, 0.0}, {0.5, {0.0, 1.0}, pi / 2.0}});
  EXPECT_NEAR(terrain.Height({10.0, 0.0}), 1.5, 1e-12);
  EXPECT_EQ(Terrain().Height({3.0, 4.0}), 0.0);
}

TEST(Terrain, GradientAndHessianAreDerivatives) {
  const Terrain terrain = Hills();
  constexpr double kStep = 1e-4;
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(37.0, -12.0)}) {
    const Terrain::Point point = terrain.At(p);
    EXPECT_EQ(point.height, terrain.Height(p));
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(i);
      const double slope = (terrain.Height(p + step) - terrain.Height(p - step)) / (2.0 * kStep);
      EXPECT_NEAR(point.gradient[i], slope, 1e-9);
      const Eigen::Vector2d bend =
          (terrain.At(p + step).gradient - terrain.At(p - step).gradient) / (2.0 * kStep);
      EXPECT_LT((point.hessian.col(i) - bend).norm(), 1e-9);
    }
    EXPECT_NEAR(terrain.Normal(p).dot(Eigen::Vector3d(1.0, 0.0, point.gradient.x())), 0.0, 1e-12);
    EXPECT_NEAR(terrain.Normal(p).norm(), 1.0, 1e-12);
  }
}

// A plane is met where the 3-4-5 triangle says; rays that rise never meet it.
TEST(Terrain, FlatGroundIsMetExactly) {
  const Terrain flat;
  EXPECT_NEAR(flat.Cast({0.0, 0.0, 3.0}, {0.8, 0.0, -0.6}, 100.0), 5.0, 1e-12);
  EXPECT_EQ(flat.Cast({0.0, 0.0, 3.0}, {0.8, 0.0, -0.6}, 4.0), 4.0);
  EXPECT_EQ(flat.Cast({0.0, 0.0, 3.0}, {0.8, 0.0, 0.6}, 100.0), 100.0);
}

// The first crossing, as walking along the ray in centimetres finds it.
TEST(Terrain, RaysMeetTheHillsWhereWalkingDoes) {
  const Terrain terrain = Hills();
  Random random(4);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    Eigen::Vector3d origin(random.Uniform(-100, 100), random.Uniform(-100, 100), 0.0);
    origin.z() = terrain.Height(origin.head<2>()) + 0.8;
    const double azimuth = random.Uniform(-3.1, 3.1);
    const Eigen::Vector3d direction =
        Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), random.Uniform(-0.15, 0.1))
            .normalized();
    const double found = terrain.Cast(origin, direction, 150.0);
    double walked = 0.0;
    for (; walked < 150.0; walked += 0.01) {
      const Eigen::Vector3d p = origin + walked * direction;
      if (p.z() < terrain.Height(p.head<2>())) break;
    }
    EXPECT_NEAR(found, std::min(walked, 150.0), 0.011) << i;
    if (found < 150.0) ++hits;
  }
  EXPECT_GT(hits, 100);
  EXPECT_LT(hits, 290);
}

}  // namespace
}  // namespace radive
