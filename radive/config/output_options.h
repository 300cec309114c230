// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// What the results folder gets besides the trajectory and the tables.
struct OutputOptions {
  enum class Map { kNone, kPoints };

  // map.ply: nothing, or the points of all keyframes in the world frame.
  Map map = Map::kPoints;

  // Edge of the cubes in which the map keeps one point [m]; 0 keeps all.
  double map_resolution = 0.25;

  std::vector<OptionField> Fields() {
    return {
        {"map",
         MakeChoice(&map, {"none", "points"}),
         "-",
         "What map.ply holds: nothing (no file), or the points of all keyframes."},
        OptionField{"map_resolution",
                    &map_resolution,
                    "m",
                    "Edge of the cubes in which map.ply keeps one point each; 0 keeps all points."}
            .AtLeast(0.0),
    };
  }

  bool IsValid(std::string* error) const { return CheckOptions("output", *this, error); }
};

}  // namespace radive
