// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/street_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace radive {
namespace {

// Horizontal distance from the nearest wall.
double Clearance(const RadarWorld& world, const Eigen::Vector2d& at) {
  double nearest = 1e9;
  for (const WallSegment& wall : world.walls()) {
    const Eigen::Vector2d edge = wall.b - wall.a;
    const double along = std::clamp((at - wall.a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (at - wall.a - along * edge).norm());
  }
  return nearest;
}

class StreetBuilderTest : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  const StreetPath path_{270.0, 113.0, 60.0};
  const RadarWorld world_ = BuildStreet(path_, GetParam());
};
INSTANTIATE_TEST_SUITE_P(Seeds, StreetBuilderTest, ::testing::Values(1, 2, 77));

TEST_P(StreetBuilderTest, BothLanesAreFree) {
  for (double s = 0.0; s < path_.length(); s += 0.5) {
    const StreetPath::Point point = path_.At(s);
    const Eigen::Vector2d left(-std::sin(point.heading), std::cos(point.heading));
    for (const double lane : {0.0, 4.0}) {
      EXPECT_GT(Clearance(world_, point.position + lane * left), 1.6)
          << "s = " << s << ", lane at " << lane;
    }
  }
}

// On the third side, in the middle: no facade within 20 m on either hand; elsewhere there are.
TEST_P(StreetBuilderTest, OneStretchIsOpen) {
  const StreetPath::Side& open_side = path_.side(2);
  const auto facade_within = [this](const Eigen::Vector2d& at, double reach) {
    for (const WallSegment& wall : world_.walls()) {
      if (wall.surface != Surface::kFacade) continue;
      if (std::min((wall.a - at).norm(), (wall.b - at).norm()) < reach) return true;
    }
    return false;
  };
  for (double x = 0.5 * open_side.straight - 30.0; x <= 0.5 * open_side.straight + 30.0; x += 5.0) {
    EXPECT_FALSE(facade_within(open_side.ToWorld(x, 0.0), 18.0)) << x;
  }
  EXPECT_TRUE(facade_within(path_.side(0).ToWorld(100.0, 0.0), 18.0));
}

TEST_P(StreetBuilderTest, HasEverything) {
  std::set<Surface> kinds;
  for (const WallSegment& wall : world_.walls()) {
    kinds.insert(wall.surface);
    EXPECT_GT(wall.height, 0.0);
  }
  EXPECT_EQ(kinds, (std::set<Surface>{Surface::kFacade, Surface::kPole, Surface::kParkedCar}));
  EXPECT_GT(world_.scatterers().size(), 1000u);
  for (const Scatterer& scatterer : world_.scatterers()) EXPECT_GT(scatterer.strength, 0.0);
}

}  // namespace
}  // namespace radive
