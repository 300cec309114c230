// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "radive/neural_map/sdf_grid.h"

namespace radive {

// Triangles over shared vertices.
struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;  // [m]
  std::vector<float> support;             // of the field at each vertex, see SdfValue [-]
  std::vector<Eigen::Vector3i>
      triangles;  // counter-clockwise seen from where the field is positive
};

// The zero level set of the grid by marching cubes (Lorensen and Cline 1987): in the cubes of which
// all eight vertices are known with a support of at least `min_support`. Vertices lie where the
// field, taken as linear along the cube's edges, is zero. Where the signs of a face are ambiguous,
// its negative corners are kept apart in both cubes that share it, so the mesh has no cracks.
TriangleMesh IsoSurface(const SdfGrid& grid, double min_support);

}  // namespace radive
