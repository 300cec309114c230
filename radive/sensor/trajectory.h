// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "radive/geometry/rigid3.h"

namespace radive {

// Pose of a body at a time: maps body coordinates to world coordinates.
struct StampedPose {
  std::int64_t stamp_ns = 0;  // [ns]
  Rigid3 T_world_body;
};

using Trajectory = std::vector<StampedPose>;

}  // namespace radive
