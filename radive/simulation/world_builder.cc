// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/world_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "radive/util/angle_units.h"
#include "radive/util/random.h"

namespace radive {
namespace {

constexpr double kSideStreet = 130.0;  // length of the streets that go on at the corners [m]
constexpr double kChamfer = 15.0;      // cut of the inner corner houses [m]
constexpr double kBackground = 160.0;  // how far the buildings behind reach beyond the loop [m]
constexpr double kHouseDepth = 10.0;   // [m]
constexpr double kBarrierStep = 3.0;   // pieces of a barrier [m]
constexpr double kFoundation = 1.0;    // how far walls reach into sloping ground [m]
constexpr double kTwoPi = 2.0 * kPi;

Terrain MakeTerrain(const WorldStyle& style, std::uint64_t seed) {
  Random random(seed);
  std::vector<Terrain::Wave> waves;
  for (const WorldStyle::Slope& slope : style.slopes) {
    const double wave_number = kTwoPi / slope.wavelength;
    const double angle = random.Uniform(0.0, kTwoPi);
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    for (const Eigen::Vector2d& direction : {along, Eigen::Vector2d(-along.y(), along.x())}) {
      waves.push_back({slope.amplitude, wave_number * direction, random.Uniform(0.0, kTwoPi)});
    }
  }
  return Terrain(std::move(waves));
}

class WorldBuilder {
 public:
  WorldBuilder(const StreetPath& path, const WorldStyle& style, std::uint64_t seed)
      : path_(path), style_(style), random_(seed), terrain_(MakeTerrain(style, seed + 1)) {}

  RadarWorld Build() {
    for (int i = 0; i < StreetPath::kNumSides; ++i) BuildSide(i);
    if (style_.has_houses) BuildBackground();
    for (const WorldStyle::Barrier& barrier : style_.barriers) AddBarrier(barrier);
    return {std::move(walls_), std::move(scatterers_), terrain_, style_.ceiling};
  }

 private:
  using Side = StreetPath::Side;

  void BuildSide(int i) {
    side_ = &path_.side(i);
    if (style_.has_houses) BuildHouses(i);
    for (const WorldStyle::Posts& posts : style_.posts) AddPosts(posts);
    for (const WorldStyle::Parking& parking : style_.parking) AddParkedCars(parking);
  }

  void BuildHouses(int i) {
    const WorldStyle::Houses& houses = style_.houses;
    const double reach = path_.corner_reach();
    const double straight = side_->straight;
    // Streets that cross at x = -reach and x = straight + reach; each takes right to left of its
    // own frame, which is turned by a quarter.
    const double begin = -reach + houses.left, end = straight + reach - houses.left;
    const double open = i == 2 ? 0.5 * (straight - houses.open_length) : end;
    const double open_end = i == 2 ? open + houses.open_length : end;

    AddFacade(begin, open, houses.right, -1.0);
    AddFacade(open_end, end, houses.right, -1.0);
    if (houses.on_left) {
      AddFacade(begin + kChamfer, open, houses.left, 1.0);
      AddFacade(open_end, end - kChamfer, houses.left, 1.0);
      // The inner corner house; the next side begins where its chamfer ends.
      AddWall({end - kChamfer, houses.left}, {end, houses.left + kChamfer}, 9.0, Surface::kFacade);
    }
    if (!houses.side_streets) return;
    const double ahead = straight + reach - houses.right;
    const double behind = -reach + houses.right;
    for (const auto& [y, outwards] : {std::pair(houses.right, -1.0), std::pair(houses.left, 1.0)}) {
      AddFacade(ahead, ahead + kSideStreet, y, outwards);
      AddFacade(behind - kSideStreet, behind, y, outwards);
    }
  }

  // Houses along the street from x0 to x1 at lateral position y; `outwards` is +1 when away from
  // the street means growing y.
  void AddFacade(double x0, double x1, double y, double outwards) {
    double x = x0;
    while (x < x1 - 2.0) {
      const WorldStyle::Houses& houses = style_.houses;
      const double length = random_.Uniform(houses.min_length, houses.max_length);
      const double house_end = std::min(x + length, x1);
      AddHouse(x, house_end, y + outwards * random_.Uniform(0.0, 1.0), outwards);
      x = house_end;
      if (random_.Uniform() < houses.gap_share) {
        x += random_.Uniform(houses.min_gap, houses.max_gap);
      }
    }
  }

  // One house: bays that stand back or out, and its two side walls.
  void AddHouse(double x0, double x1, double y, double outwards) {
    const double height = random_.Uniform(style_.houses.min_height, style_.houses.max_height);
    double x = x0, bay = y;
    AddWall({x0, y + outwards * kHouseDepth}, {x0, y}, height, Surface::kFacade);
    while (x < x1) {
      const double next_x = std::min(x + random_.Uniform(1.2, 4.0), x1);
      AddWall({x, bay}, {next_x, bay}, height, Surface::kFacade);
      AddFacadeScatterer(x, bay, height);
      const double next_bay =
          random_.Uniform() < 0.6 ? y + outwards * random_.Uniform(-0.6, 1.2) : bay;
      if (next_x < x1 && next_bay != bay) {
        AddWall({next_x, bay}, {next_x, next_bay}, height, Surface::kFacade);
        bay = next_bay;
      }
      x = next_x;
    }
    AddWall({x1, bay}, {x1, y + outwards * kHouseDepth}, height, Surface::kFacade);
    AddFacadeScatterer(x1, bay, height);
  }

  // Edges of bays, window sills and gutters, at one to three heights.
  void AddFacadeScatterer(double x, double y, double height) {
    const auto count = 1 + random_.Index(3);
    for (std::uint64_t k = 0; k < count; ++k) {
      const double z = std::min(height, 0.3 + 6.0 * std::pow(random_.Uniform(), 1.5));
      AddScatterer({x, y}, z, 1.0);
    }
  }

  void AddPosts(const WorldStyle::Posts& posts) {
    const double half = posts.half_width, y = posts.y;
    for (double x = random_.Uniform(0.0, 15.0); x < side_->straight;
         x += random_.Uniform(posts.min_spacing, posts.max_spacing)) {
      AddBox(x - half, x + half, y - half, y + half, posts.height, posts.surface);
      for (const double share : {1.0 / 12.0, 1.0 / 3.0, 7.0 / 12.0, 5.0 / 6.0}) {
        AddScatterer({x, y}, share * posts.height, posts.strength);
      }
      const double crown = posts.crown_half_width;
      if (crown <= 0.0) continue;
      // Without scatterers: leaves move, and nothing repeats.
      AddBox(x - crown,
             x + crown,
             y - crown,
             y + crown,
             posts.crown_top,
             Surface::kVegetation,
             posts.crown_bottom);
    }
  }

  void AddParkedCars(const WorldStyle::Parking& parking) {
    for (double x = random_.Uniform(3.0, 20.0); x < side_->straight - 5.0;) {
      const double length = random_.Uniform(3.8, 4.9);
      const double width = random_.Uniform(1.7, 1.9);
      const double height = random_.Uniform(1.4, 1.9);
      const double along = parking.across ? width : length;
      const double y0 = parking.y - 0.5 * (parking.across ? length : width);
      const double y1 = parking.y + 0.5 * (parking.across ? length : width);
      AddBox(x, x + along, y0, y1, height, Surface::kParkedCar);
      for (const double corner_x : {x, x + along}) {
        AddScatterer({corner_x, y0}, 0.6, 2.0);
        AddScatterer({corner_x, y1}, 0.6, 2.0);
      }
      x += along + (random_.Uniform() < 1.0 - parking.hole_share
                        ? random_.Uniform(parking.min_gap, parking.max_gap)
                        : random_.Uniform(parking.min_hole, parking.max_hole));
    }
  }

  // A wall that follows the lane around the loop.
  void AddBarrier(const WorldStyle::Barrier& barrier) {
    const auto at = [&](double s) -> Eigen::Vector2d {
      const StreetPath::Point point = path_.At(s);
      return point.position +
             barrier.y * Eigen::Vector2d(-std::sin(point.heading), std::cos(point.heading));
    };
    const auto pieces = static_cast<int>(path_.length() / kBarrierStep);
    for (int i = 0; i < pieces; ++i) {
      const double step = path_.length() / pieces;
      AddWorldWall(at(i * step), at((i + 1) * step), barrier.height, barrier.surface, 0.0);
    }
    if (barrier.mark_spacing <= 0.0) return;
    for (double s = 0.0; s < path_.length();
         s += barrier.mark_spacing * random_.Uniform(0.5, 1.5)) {
      const double z = barrier.height * random_.Uniform(0.1, 0.9);
      AddWorldScatterer(at(s), z, barrier.mark_strength);
    }
  }

  // Taller buildings away from the streets, seen through gaps and over the first row.
  void BuildBackground() {
    const Side& first = path_.side(0);
    const Side& second = path_.side(1);
    const double reach = path_.corner_reach();
    const Eigen::Vector2d low(-reach - kBackground, -kBackground);
    const Eigen::Vector2d high(first.straight + reach + kBackground,
                               second.straight + 2.0 * reach + kBackground);
    side_ = &first;
    for (int k = 0; k < style_.houses.background; ++k) {
      const double x = random_.Uniform(low.x(), high.x()), y = random_.Uniform(low.y(), high.y());
      const double width = random_.Uniform(8.0, 30.0), depth = random_.Uniform(8.0, 30.0);
      const double height = random_.Uniform(8.0, 32.0);
      if (OverlapsStreet({x, y}, {x + width, y + depth})) continue;
      AddBox(x, x + width, y, y + depth, height, Surface::kFacade);
      const auto count = 4 + random_.Index(5);
      for (std::uint64_t j = 0; j < count; ++j) {
        const bool along_x = random_.Uniform() < 0.5;
        const double across = random_.Uniform() < 0.5 ? 0.0 : 1.0, along = random_.Uniform();
        AddScatterer(
            {x + width * (along_x ? along : across), y + depth * (along_x ? across : along)},
            random_.Uniform(0.5, height),
            3.0);
      }
    }
  }

  // Whether a box of the world touches the strip of any street, its houses included.
  bool OverlapsStreet(const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
    constexpr double kHouses = 12.0;
    for (int i = 0; i < StreetPath::kNumSides; ++i) {
      const Side& side = path_.side(i);
      const double y0 = (low - side.origin).dot(side.left);
      const double y1 = (high - side.origin).dot(side.left);
      if (std::max(y0, y1) > style_.houses.right - kHouses &&
          std::min(y0, y1) < style_.houses.left + kHouses) {
        return true;
      }
    }
    // Long corners leave the strips.
    for (double s = 0.0; s < path_.length(); s += 5.0) {
      const Eigen::Vector2d at = path_.At(s).position;
      if (((at - low).array() > -kHouses).all() && ((high - at).array() > -kHouses).all()) {
        return true;
      }
    }
    return false;
  }

  void AddWall(const Eigen::Vector2d& a,
               const Eigen::Vector2d& b,
               double height,
               Surface surface,
               double bottom = 0.0) {
    AddWorldWall(
        side_->ToWorld(a.x(), a.y()), side_->ToWorld(b.x(), b.y()), height, surface, bottom);
  }

  // `height` and `bottom` over the ground.
  void AddWorldWall(const Eigen::Vector2d& a,
                    const Eigen::Vector2d& b,
                    double height,
                    Surface surface,
                    double bottom) {
    if (terrain_.is_flat()) {
      walls_.push_back({a, b, height, surface, bottom});
      return;
    }
    const double ground_a = terrain_.Height(a), ground_b = terrain_.Height(b);
    const double foundation = bottom > 0.0 ? 0.0 : kFoundation;
    walls_.push_back({a,
                      b,
                      std::max(ground_a, ground_b) + height,
                      surface,
                      std::min(ground_a, ground_b) + bottom - foundation});
  }

  void AddBox(double x0,
              double x1,
              double y0,
              double y1,
              double height,
              Surface surface,
              double bottom = 0.0) {
    AddWall({x0, y0}, {x1, y0}, height, surface, bottom);
    AddWall({x1, y0}, {x1, y1}, height, surface, bottom);
    AddWall({x1, y1}, {x0, y1}, height, surface, bottom);
    AddWall({x0, y1}, {x0, y0}, height, surface, bottom);
  }

  void AddScatterer(const Eigen::Vector2d& at, double z, double strength) {
    AddWorldScatterer(side_->ToWorld(at.x(), at.y()), z, strength);
  }

  void AddWorldScatterer(const Eigen::Vector2d& p, double z, double strength) {
    // Log-normal: few scatterers dominate, as radar cross sections do.
    scatterers_.push_back(
        {{p.x(), p.y(), z + terrain_.Height(p)}, strength * std::exp(0.8 * random_.Normal())});
  }

  const StreetPath& path_;
  const WorldStyle& style_;
  Random random_;
  const Terrain terrain_;
  const Side* side_ = nullptr;
  std::vector<WallSegment> walls_;
  std::vector<Scatterer> scatterers_;
};

}  // namespace

RadarWorld BuildWorld(const StreetPath& path, const WorldStyle& style, std::uint64_t seed) {
  return WorldBuilder(path, style, seed).Build();
}

}  // namespace radive
