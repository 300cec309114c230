// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// What the results folder gets besides the trajectory and the tables.
struct OutputOptions {
  enum class Map { kNone, kPoints, kSurface, kMesh };

  // map.ply: nothing, or the points of all keyframes in the world frame; of the neural submap the
  // points on the surface, and the surface as a mesh.
  Map map = Map::kPoints;

  // Edge of the cubes in which the map keeps one point [m]; 0 keeps all.
  double map_resolution = 0.25;

  double mesh_resolution = 0.25;  // edge of the cubes of marching cubes [m]
  double slice_height = 0.0;      // z of the slice through the field, world frame [m]

  bool NeedsSurface() const { return map == Map::kSurface || map == Map::kMesh; }

  std::vector<OptionField> Fields() {
    return {
        {"map",
         MakeChoice(&map, {"none", "points", "surface", "mesh"}),
         "-",
         "No map.ply; one of all keyframes' points; with submap.type sdf: of the surface points "
         "(and all in neural_points.ply); these, mesh.ply and sdf_slice.ply."},
        OptionField{"map_resolution",
                    &map_resolution,
                    "m",
                    "Edge of the cubes in which map.ply keeps one point each; 0 keeps all points."}
            .AtLeast(0.0),
        OptionField{"mesh_resolution",
                    &mesh_resolution,
                    "m",
                    "Edge of the cubes from which mesh.ply is made, and grid of sdf_slice.ply."}
            .Above(0.0),
        OptionField{
            "slice_height", &slice_height, "m", "Height of sdf_slice.ply: z in the world frame."},
    };
  }

  bool IsValid(std::string* error) const { return CheckOptions("output", *this, error); }
};

}  // namespace radive
