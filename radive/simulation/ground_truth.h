// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "radive/geometry/rigid3.h"

namespace radive {

// What a simulated return really is. The values are those of the label files.
enum class ReturnLabel : std::uint8_t {
  kStatic = 0,     // first echo of the world, the parked cars included
  kGhost = 1,      // multipath: over a wall, the own car or the ground
  kMoving = 2,     // other road users, also while they stand
  kClutter = 3,    // noise peaks, and side lobes of a real return
  kDuplicate = 4,  // second return behind a real one
  kAmbiguous = 5,  // a real return at a wrong elevation
};
constexpr int kNumReturnLabels = 6;

// The truth beside a simulated scan.
struct GroundTruth {
  Rigid3 T_world_radar;                               // exact
  Eigen::Vector3d v_radar = Eigen::Vector3d::Zero();  // of the radar, in the radar frame [m/s]

  // One entry per return.
  std::vector<ReturnLabel> labels;

  // Where the return would be without noise, in the radar frame [m]: on the surface itself for
  // static and moving returns. Three-dimensional for planar sensors as well.
  std::vector<Eigen::Vector3d> noise_free_positions;
};

}  // namespace radive
