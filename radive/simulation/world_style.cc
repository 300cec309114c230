// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/world_style.h"

#include <glog/logging.h>

namespace radive {
namespace {

WorldStyle::Posts LampPosts(double y) {
  WorldStyle::Posts posts;
  posts.y = y;
  return posts;
}

WorldStyle::Posts Trees(double y, double min_spacing, double max_spacing) {
  WorldStyle::Posts trees;
  trees.y = y;
  trees.min_spacing = min_spacing;
  trees.max_spacing = max_spacing;
  trees.half_width = 0.18;
  trees.height = 2.5;
  trees.strength = 1.0;
  trees.crown_half_width = 1.6;
  return trees;
}

// The loop is 1006 m long, its tightest radius 19 m.
WorldStyle Street() {
  WorldStyle style;
  style.posts = {LampPosts(-6.0), LampPosts(10.0)};
  WorldStyle::Parking parking;
  parking.y = -3.6;
  style.parking.push_back(parking);
  parking.y = 7.6;
  style.parking.push_back(parking);
  return style;
}

WorldStyle Avenue() {
  WorldStyle style;
  style.long_side = 700.0;
  style.short_side = 300.0;
  style.corner = 220.0;
  style.houses.right = -32.0;
  style.houses.on_left = false;
  style.houses.gap_share = 0.7;
  style.houses.min_gap = 15.0;
  style.houses.max_gap = 70.0;
  style.houses.max_height = 25.0;
  style.houses.open_length = 250.0;
  WorldStyle::Posts lamps = LampPosts(-6.5);
  lamps.min_spacing = 28.0;
  lamps.max_spacing = 34.0;
  lamps.height = 9.0;
  style.posts = {lamps, Trees(-13.0, 9.0, 22.0), Trees(24.0, 9.0, 22.0)};
  style.barriers.push_back({7.0, 0.9, 4.0, 0.6, Surface::kPole});
  return style;
}

// 6 % of slope at most places, 13 % at the steepest.
WorldStyle Campus() {
  WorldStyle style;
  style.long_side = 170.0;
  style.short_side = 80.0;
  style.corner = 45.0;
  style.houses.right = -14.0;
  style.houses.left = 17.0;
  style.houses.min_length = 20.0;
  style.houses.max_length = 45.0;
  style.houses.min_height = 8.0;
  style.houses.max_height = 20.0;
  style.houses.gap_share = 1.0;
  style.houses.min_gap = 12.0;
  style.houses.max_gap = 45.0;
  style.houses.open_length = 50.0;
  style.houses.side_streets = false;
  style.houses.background = 60;
  style.posts = {LampPosts(-4.0), Trees(-8.0, 7.0, 22.0), Trees(9.0, 7.0, 22.0)};
  style.slopes = {{2.2, 190.0}, {0.5, 71.0}};
  return style;
}

WorldStyle CarPark() {
  WorldStyle style;
  style.long_side = 80.0;
  style.short_side = 34.0;
  style.corner = 22.0;
  style.houses.right = -34.0;
  style.houses.on_left = false;
  style.houses.min_length = 25.0;
  style.houses.max_length = 60.0;
  style.houses.open_length = 30.0;
  style.houses.side_streets = false;
  style.houses.background = 0;
  WorldStyle::Parking row;
  row.across = true;
  row.min_gap = 0.5;
  row.max_gap = 0.9;
  row.hole_share = 0.3;
  row.min_hole = 2.5;
  row.max_hole = 8.0;
  for (const double y : {-5.5, -10.6, -20.5, 9.0, 14.1}) {
    row.y = y;
    style.parking.push_back(row);
  }
  WorldStyle::Posts pillars = LampPosts(-8.05);
  pillars.min_spacing = 7.8;
  pillars.max_spacing = 8.2;
  pillars.half_width = 0.25;
  pillars.height = 3.0;
  pillars.surface = Surface::kConcrete;
  style.posts.push_back(pillars);
  pillars.y = 11.55;
  style.posts.push_back(pillars);
  return style;
}

// Few things tell one metre of it from the next.
WorldStyle Tunnel() {
  WorldStyle style;
  style.long_side = 320.0;
  style.short_side = 90.0;
  style.corner = 110.0;
  style.has_houses = false;
  style.barriers.push_back({-3.2, 5.5, 22.0, 1.0, Surface::kConcrete});
  style.barriers.push_back({7.2, 5.5, 30.0, 1.0, Surface::kConcrete});
  style.ceiling = 5.5;
  return style;
}

}  // namespace

const WorldStyle& StyleOf(WorldType type) {
  static const std::vector<WorldStyle> styles = {Street(), Avenue(), Campus(), CarPark(), Tunnel()};
  const auto i = static_cast<std::size_t>(type);
  CHECK_LT(i, styles.size());
  return styles[i];
}

const std::vector<std::string>& WorldNames() {
  static const std::vector<std::string> names = {
      "street", "avenue", "campus", "car_park", "tunnel"};
  return names;
}

}  // namespace radive
