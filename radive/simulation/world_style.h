// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <string>
#include <vector>

#include "radive/simulation/radar_world.h"

namespace radive {

enum class WorldType {
  kStreet,   // a town: rows of houses, parked cars, poles
  kAvenue,   // a wide road out of town: distant buildings, trees, a guard rail
  kCampus,   // single buildings and trees on slopes
  kCarPark,  // rows of parked cars and pillars
  kTunnel,   // bare walls and a roof
};

// What stands around the driving lane, as numbers. Lateral positions are distances from the lane,
// positive to the left; nothing may stand between -1.6 m and kLeftLaneEdge.
struct WorldStyle {
  static constexpr double kLeftLaneEdge = 5.6;  // of the oncoming lane [m]

  // Rows of houses along both sides.
  struct Houses {
    double right = -8.5, left = 12.5;            // their fronts [m]
    bool on_left = true;                         // inside the loop too
    double min_length = 9.0, max_length = 26.0;  // [m]
    double min_height = 5.0, max_height = 13.0;  // [m]
    double gap_share = 0.35;                     // of the houses are followed by a gap [-]
    double min_gap = 2.5, max_gap = 9.0;         // [m]
    double open_length = 100.0;                  // stretch of the third side without any [m]
    bool side_streets = true;                    // go on straight at the corners
    int background = 260;                        // taller buildings behind
  };
  // Boxes at intervals: lamp posts, pillars, trees.
  struct Posts {
    double y = 0.0;                             // [m]
    double min_spacing = 15, max_spacing = 35;  // [m]
    double half_width = 0.12, height = 6.0;     // [m]
    double strength = 2.5;                      // of its scatterers [-]
    Surface surface = Surface::kPole;
    double crown_half_width = 0.0;               // of a tree [m]; 0: none
    double crown_bottom = 2.2, crown_top = 8.0;  // over the ground [m]
  };
  struct Parking {
    double y = 0.0;                          // middle of the row [m]
    bool across = false;                     // noses to the lane, instead of along it
    double min_gap = 0.8, max_gap = 2.0;     // between neighbours [m]
    double hole_share = 0.3;                 // of the cars are followed by a hole [-]
    double min_hole = 8.0, max_hole = 40.0;  // [m]
  };
  // A wall all along the lane, corners included.
  struct Barrier {
    double y = 0.0;             // [m]
    double height = 0.0;        // [m]
    double mark_spacing = 0.0;  // mean distance of its scatterers: niches, signs, joints [m]
    double mark_strength = 1.0;
    Surface surface = Surface::kConcrete;
  };
  // The ground: a wave of this height and length in each of the two directions of the plane.
  struct Slope {
    double amplitude = 0.0;   // [m]
    double wavelength = 0.0;  // [m]
  };

  double long_side = 270.0, short_side = 113.0, corner = 60.0;  // of the StreetPath [m]
  bool has_houses = true;
  Houses houses;
  std::vector<Posts> posts;
  std::vector<Parking> parking;
  std::vector<Barrier> barriers;
  std::vector<Slope> slopes;
  double ceiling = std::numeric_limits<double>::infinity();  // [m]
};

const WorldStyle& StyleOf(WorldType type);

// The words for WorldType in settings, in its order.
const std::vector<std::string>& WorldNames();

}  // namespace radive
