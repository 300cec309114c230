// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/world_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

namespace radive {
namespace {

// A place built with a seed.
class WorldBuilderTest : public ::testing::TestWithParam<std::tuple<WorldType, std::uint64_t>> {
 protected:
  const WorldStyle& style_ = StyleOf(std::get<0>(GetParam()));
  const StreetPath path_{style_.long_side, style_.short_side, style_.corner};
  const RadarWorld world_ = BuildWorld(path_, style_, std::get<1>(GetParam()));
};
INSTANTIATE_TEST_SUITE_P(Places,
                         WorldBuilderTest,
                         ::testing::Combine(::testing::Values(WorldType::kStreet,
                                                              WorldType::kAvenue,
                                                              WorldType::kCampus,
                                                              WorldType::kCarPark,
                                                              WorldType::kTunnel),
                                            ::testing::Values(1, 2, 77)),
                         [](const auto& place) {
                           return WorldNames()[static_cast<std::size_t>(std::get<0>(place.param))] +
                                  "_" + std::to_string(std::get<1>(place.param));
                         });

TEST_P(WorldBuilderTest, BothLanesAreFree) {
  for (double s = 0.0; s < path_.length(); s += 2.0) {
    const StreetPath::Point point = path_.At(s);
    const Eigen::Vector2d left(-std::sin(point.heading), std::cos(point.heading));
    for (const double lane : {0.0, 4.0}) {
      const Eigen::Vector2d at = point.position + lane * left;
      const double ground = world_.terrain().Height(at);
      double clearance = 1e9;
      for (const WallSegment& wall : world_.walls()) {
        if (wall.base > ground + 2.0) continue;  // driven under
        const Eigen::Vector2d edge = wall.b - wall.a;
        const double along = std::clamp((at - wall.a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
        clearance = std::min(clearance, (at - wall.a - along * edge).norm());
      }
      EXPECT_GT(clearance, 1.2) << "s = " << s << ", lane at " << lane;
    }
  }
}

TEST_P(WorldBuilderTest, WallsStandOnTheGround) {
  for (const WallSegment& wall : world_.walls()) {
    EXPECT_GT(wall.height, wall.base);
    if (wall.surface == Surface::kVegetation) continue;
    const Eigen::Vector2d middle = 0.5 * (wall.a + wall.b);
    for (const Eigen::Vector2d& p : {wall.a, middle, wall.b}) {
      EXPECT_LE(wall.base, world_.terrain().Height(p) + 1e-9);
    }
  }
}

TEST_P(WorldBuilderTest, ScatterersAreAboveTheGround) {
  EXPECT_GT(world_.scatterers().size(), 50u);
  for (const Scatterer& scatterer : world_.scatterers()) {
    EXPECT_GT(scatterer.strength, 0.0);
    EXPECT_GT(scatterer.position.z(), world_.terrain().Height(scatterer.position.head<2>()));
  }
}

std::set<Surface> SurfacesOf(WorldType type) {
  const WorldStyle& style = StyleOf(type);
  const StreetPath path(style.long_side, style.short_side, style.corner);
  const RadarWorld world = BuildWorld(path, style, 1);
  std::set<Surface> surfaces;
  for (const WallSegment& wall : world.walls()) surfaces.insert(wall.surface);
  return surfaces;
}

TEST(WorldBuilder, EachPlaceHasItsThings) {
  using Surfaces = std::set<Surface>;
  EXPECT_EQ(SurfacesOf(WorldType::kStreet),
            (Surfaces{Surface::kFacade, Surface::kPole, Surface::kParkedCar}));
  EXPECT_EQ(SurfacesOf(WorldType::kAvenue),
            (Surfaces{Surface::kFacade, Surface::kPole, Surface::kVegetation}));
  EXPECT_EQ(SurfacesOf(WorldType::kCampus),
            (Surfaces{Surface::kFacade, Surface::kPole, Surface::kVegetation}));
  EXPECT_EQ(SurfacesOf(WorldType::kCarPark),
            (Surfaces{Surface::kFacade, Surface::kParkedCar, Surface::kConcrete}));
  EXPECT_EQ(SurfacesOf(WorldType::kTunnel), (Surfaces{Surface::kConcrete}));
}

// On the third side of the street, in the middle: no facade within 18 m; elsewhere there are.
TEST(WorldBuilder, OneStretchOfTheStreetIsOpen) {
  const WorldStyle& style = StyleOf(WorldType::kStreet);
  const StreetPath path(style.long_side, style.short_side, style.corner);
  const RadarWorld world = BuildWorld(path, style, 1);
  const StreetPath::Side& open_side = path.side(2);
  const auto facade_within = [&](const Eigen::Vector2d& at, double reach) {
    for (const WallSegment& wall : world.walls()) {
      if (wall.surface != Surface::kFacade) continue;
      if (std::min((wall.a - at).norm(), (wall.b - at).norm()) < reach) return true;
    }
    return false;
  };
  for (double x = 0.5 * open_side.straight - 30.0; x <= 0.5 * open_side.straight + 30.0; x += 5.0) {
    EXPECT_FALSE(facade_within(open_side.ToWorld(x, 0.0), 18.0)) << x;
  }
  EXPECT_TRUE(facade_within(path.side(0).ToWorld(100.0, 0.0), 18.0));
}

TEST(WorldBuilder, TheCampusIsHilly) {
  const WorldStyle& style = StyleOf(WorldType::kCampus);
  const StreetPath path(style.long_side, style.short_side, style.corner);
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    const RadarWorld world = BuildWorld(path, style, seed);
    double steepest = 0.0, lowest = 1e9, highest = -1e9;
    for (double s = 0.0; s < path.length(); s += 2.0) {
      const Terrain::Point ground = world.terrain().At(path.At(s).position);
      steepest = std::max(steepest, ground.gradient.norm());
      lowest = std::min(lowest, ground.height);
      highest = std::max(highest, ground.height);
    }
    EXPECT_GT(steepest, 0.08) << seed;
    EXPECT_LT(steepest, 0.25) << seed;
    EXPECT_GT(highest - lowest, 3.0) << seed;
  }
}

}  // namespace
}  // namespace radive
