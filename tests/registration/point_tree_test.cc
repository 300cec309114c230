// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/registration/point_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "radive/util/random.h"

namespace radive {
namespace {

TEST(PointTree, NearestEqualsBruteForce) {
  Random random(1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 500; ++i) {
    points.emplace_back(random.Uniform(-20, 20), random.Uniform(-20, 20), random.Uniform(-2, 2));
  }
  const PointTree tree(points);
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector3d p(random.Uniform(-25, 25), random.Uniform(-25, 25), 0.0);
    std::size_t expected = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((points[i] - p).norm() < (points[expected] - p).norm()) expected = i;
    }
    const double distance = (points[expected] - p).norm();
    ASSERT_EQ(tree.Nearest(p, distance + 1e-9), expected);
    EXPECT_FALSE(tree.Nearest(p, distance - 1e-9));
    const std::vector<std::uint32_t> five = tree.Nearest(p, 5);
    ASSERT_EQ(five.size(), 5u);
    EXPECT_EQ(five[0], expected);
    for (std::size_t i = 1; i < 5; ++i) {
      EXPECT_GE((points[five[i]] - p).norm(), (points[five[i - 1]] - p).norm());
    }
  }
}

TEST(PointTree, NothingNearIsNothing) {
  const PointTree empty({});
  EXPECT_FALSE(empty.Nearest(Eigen::Vector3d::Zero(), 1e9));
  EXPECT_TRUE(empty.Nearest(Eigen::Vector3d::Zero(), 3).empty());
  EXPECT_FALSE(empty.Normal(Eigen::Vector3d::Zero(), 5));
}

// Points of the plane 3 x + 4 z = 5.
TEST(PointTree, NormalIsThatOfThePlane) {
  Random random(2);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 50; ++i) {
    const double x = random.Uniform(-1, 1);
    points.emplace_back(x, random.Uniform(-1, 1), (5.0 - 3.0 * x) / 4.0);
  }
  const PointTree tree(points);
  const auto normal = tree.Normal(points[7], 12);
  ASSERT_TRUE(normal);
  EXPECT_NEAR(std::abs(normal->dot(Eigen::Vector3d(0.6, 0.0, 0.8))), 1.0, 1e-12);
}

// A wall seen by a sensor without elevation: a line at 3-4-5, whose normal across the vertical is
// (4, -3, 0) / 5. In three dimensions a line has none.
TEST(PointTree, PointsOnALineHaveANormalOnlyAcrossUp) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 10; ++i) points.emplace_back(3.0 * i, 4.0 * i, 0.0);
  const PointTree tree(points);
  EXPECT_FALSE(tree.Normal(points[4], 5));
  const auto normal = tree.NormalAcross(Eigen::Vector3d::UnitZ(), points[4], 5);
  ASSERT_TRUE(normal);
  EXPECT_NEAR(std::abs(normal->dot(Eigen::Vector3d(0.8, -0.6, 0.0))), 1.0, 1e-12);
}

TEST(PointTree, PointsInOnePlaceHaveNoNormal) {
  const PointTree tree(std::vector<Eigen::Vector3d>(8, Eigen::Vector3d(1.0, 2.0, 3.0)));
  EXPECT_FALSE(tree.Normal({1.0, 2.0, 3.0}, 5));
  EXPECT_FALSE(tree.NormalAcross(Eigen::Vector3d::UnitZ(), {1.0, 2.0, 3.0}, 5));
  const PointTree two({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  EXPECT_FALSE(two.Normal({0.0, 0.0, 0.0}, 5));
}

}  // namespace
}  // namespace radive
