// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/street_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "radive/util/random.h"

namespace radive {
namespace {

// Cross-section of the street: distances from the driving lane, positive to the left [m].
constexpr double kRightFacade = -8.5;
constexpr double kLeftFacade = 12.5;
constexpr double kRightPoles = -6.0;
constexpr double kLeftPoles = 10.0;
constexpr double kRightParking = -3.6;
constexpr double kLeftParking = 7.6;

constexpr double kSideStreet = 130.0;  // length of the streets that go on at the corners [m]
constexpr double kChamfer = 15.0;      // cut of the inner corner houses [m]
constexpr double kOpenLength = 100.0;  // stretch without facades [m]
constexpr double kBackground = 160.0;  // how far the buildings behind reach beyond the loop [m]

class StreetBuilder {
 public:
  StreetBuilder(const StreetPath& path, std::uint64_t seed) : path_(path), random_(seed) {}

  RadarWorld Build() {
    for (int i = 0; i < StreetPath::kNumSides; ++i) BuildSide(i);
    BuildBackground();
    return {std::move(walls_), std::move(scatterers_)};
  }

 private:
  using Side = StreetPath::Side;

  void BuildSide(int i) {
    side_ = &path_.side(i);
    const double reach = path_.corner_reach();
    const double straight = side_->straight;
    // Streets that cross at x = -reach and x = straight + reach; each takes kRightFacade to
    // kLeftFacade of its own frame, which is turned by a quarter.
    const double begin = -reach + kLeftFacade, end = straight + reach - kLeftFacade;
    const double open = i == 2 ? 0.5 * (straight - kOpenLength) : end;
    const double open_end = i == 2 ? open + kOpenLength : end;

    AddFacade(begin, open, kRightFacade, -1.0);
    AddFacade(open_end, end, kRightFacade, -1.0);
    AddFacade(begin + kChamfer, open, kLeftFacade, 1.0);
    AddFacade(open_end, end - kChamfer, kLeftFacade, 1.0);
    // The inner corner house; the next side begins where its chamfer ends.
    AddWall({end - kChamfer, kLeftFacade}, {end, kLeftFacade + kChamfer}, 9.0, Surface::kFacade);

    const double ahead = straight + reach - kRightFacade;
    const double behind = -reach + kRightFacade;
    for (const auto& [y, outwards] : {std::pair(kRightFacade, -1.0), std::pair(kLeftFacade, 1.0)}) {
      AddFacade(ahead, ahead + kSideStreet, y, outwards);
      AddFacade(behind - kSideStreet, behind, y, outwards);
    }
    AddPoles(kRightPoles);
    AddPoles(kLeftPoles);
    AddParkedCars(kRightParking);
    AddParkedCars(kLeftParking);
  }

  // Houses along the street from x0 to x1 at lateral position y; `outwards` is +1 when away from
  // the street means growing y.
  void AddFacade(double x0, double x1, double y, double outwards) {
    double x = x0;
    while (x < x1 - 2.0) {
      const double house_end = std::min(x + random_.Uniform(9.0, 26.0), x1);
      AddHouse(x, house_end, y + outwards * random_.Uniform(0.0, 1.0), outwards);
      x = house_end;
      if (random_.Uniform() < 0.35) x += random_.Uniform(2.5, 9.0);
    }
  }

  // One house: bays that stand back or out, and its two side walls.
  void AddHouse(double x0, double x1, double y, double outwards) {
    const double height = random_.Uniform(5.0, 13.0);
    const double depth = 10.0;
    double x = x0, bay = y;
    AddWall({x0, y + outwards * depth}, {x0, y}, height, Surface::kFacade);
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
    AddWall({x1, bay}, {x1, y + outwards * depth}, height, Surface::kFacade);
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

  void AddPoles(double y) {
    constexpr double kHalf = 0.12;
    for (double x = random_.Uniform(0.0, 15.0); x < side_->straight; x += random_.Uniform(15, 35)) {
      AddBox(x - kHalf, x + kHalf, y - kHalf, y + kHalf, 6.0, Surface::kPole);
      for (const double z : {0.5, 2.0, 3.5, 5.0}) AddScatterer({x, y}, z, 2.5);
    }
  }

  void AddParkedCars(double y) {
    for (double x = random_.Uniform(3.0, 20.0); x < side_->straight - 5.0;) {
      const double length = random_.Uniform(3.8, 4.9);
      const double half_width = 0.5 * random_.Uniform(1.7, 1.9);
      const double height = random_.Uniform(1.4, 1.9);
      AddBox(x, x + length, y - half_width, y + half_width, height, Surface::kParkedCar);
      for (const double corner_x : {x, x + length}) {
        AddScatterer({corner_x, y - half_width}, 0.6, 2.0);
        AddScatterer({corner_x, y + half_width}, 0.6, 2.0);
      }
      // Rows of cars, interrupted by longer free stretches.
      x += length + (random_.Uniform() < 0.7 ? random_.Uniform(0.8, 2.0) : random_.Uniform(8, 40));
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
    for (int k = 0; k < 260; ++k) {
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
      if (std::max(y0, y1) > kRightFacade - kHouses && std::min(y0, y1) < kLeftFacade + kHouses) {
        return true;
      }
    }
    return false;
  }

  void AddWall(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double height, Surface surface) {
    walls_.push_back({side_->ToWorld(a.x(), a.y()), side_->ToWorld(b.x(), b.y()), height, surface});
  }

  void AddBox(double x0, double x1, double y0, double y1, double height, Surface surface) {
    AddWall({x0, y0}, {x1, y0}, height, surface);
    AddWall({x1, y0}, {x1, y1}, height, surface);
    AddWall({x1, y1}, {x0, y1}, height, surface);
    AddWall({x0, y1}, {x0, y0}, height, surface);
  }

  void AddScatterer(const Eigen::Vector2d& at, double z, double strength) {
    const Eigen::Vector2d p = side_->ToWorld(at.x(), at.y());
    // Log-normal: few scatterers dominate, as radar cross sections do.
    scatterers_.push_back({{p.x(), p.y(), z}, strength * std::exp(0.8 * random_.Normal())});
  }

  const StreetPath& path_;
  Random random_;
  const Side* side_ = nullptr;
  std::vector<WallSegment> walls_;
  std::vector<Scatterer> scatterers_;
};

}  // namespace

RadarWorld BuildStreet(const StreetPath& path, std::uint64_t seed) {
  return StreetBuilder(path, seed).Build();
}

}  // namespace radive
