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
  enum class Frame {
    kBody,      // of the odometry, motion.body
    kRadar,     // the radar of the first scan
    kVehicle,   // origin at the rear axle, see SensorOptions
    kReference  // the body whose poses the ground truth has, see ReferenceOptions
  };

  // Whose pose the trajectory files, scans.csv and map.ply are of. The world frame is that body's
  // at the first scan. The odometry itself does not depend on it.
  Frame frame = Frame::kBody;

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
        {"frame",
         MakeChoice(&frame, {"body", "radar", "vehicle", "reference"}),
         "-",
         "Whose pose is written: that of motion.body, of the radar (of the first scan), of the "
         "vehicle (sensor.mount_*), or of the ground truth's body (reference.mount)."},
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
