// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "radive/config/output_options.h"
#include "radive/geometry/rigid3.h"
#include "radive/neural_map/iso_surface.h"
#include "radive/neural_map/sdf_grid.h"
#include "radive/neural_map/surface_options.h"
#include "radive/odometry/odometry.h"

namespace radive {

// The maps of a results folder: binary little-endian PLY in the world frame, all numbers float32.

struct MapFile {
  std::string name;
  std::optional<std::string> bytes;  // none: the run has no such file
};

// All files that `output` may ask for:
//   map.ply            points of the keyframes or, of a neural submap, its surface points
//   neural_points.ply  all its points, before extraction
//   mesh.ply           its surface as triangles
//   sdf_slice.ply      a horizontal slice through its field
// `points` are of the keyframes [m], `surfaces` of the neural submaps.
std::vector<MapFile> MakeMapFiles(const OutputOptions& output,
                                  const SurfaceOptions& surface,
                                  const std::vector<Eigen::Vector3d>& points,
                                  const std::vector<RadarSurface>& surfaces);

// Vertices x y z [m].
std::string PointsPly(const std::vector<Eigen::Vector3d>& points);

// Vertices x y z [m], nx ny nz (unit, to the side that the radar saw), sdf [m], certainty (support,
// see SdfValue).
std::string SurfacePointsPly(const std::vector<SurfacePoint>& points);

// Vertices x y z [m], certainty; triangles counter-clockwise seen from the side that the radar saw.
std::string MeshPly(const std::vector<TriangleMesh>& meshes);

struct PlacedGrid {
  Rigid3 T_world_map;
  const SdfGrid* grid;
};

// The layer of the grids' vertices next to the height z [m] in their own frames: vertices x y z
// [m], sdf [m], certainty, those with a support of `min_support` or more.
std::string SlicePly(const std::vector<PlacedGrid>& grids, double z, double min_support);

}  // namespace radive
