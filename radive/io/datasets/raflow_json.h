// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "radive/geometry/matrix_pose.h"
#include "radive/io/points/point_table.h"

namespace radive {

// A file of RaFlow: two scans in a row. The fields of the tables are car_loc_x, car_loc_y,
// car_loc_z [m], car_vel_r [m/s], rcs [dBsm] and power [dB], as float64.
struct RaFlowPair {
  PointTable first;   // pc1
  PointTable second;  // pc2
  std::int64_t interval_ns = 0;
};

// Takes the text of such a file apart. False, with the key and the expectation in `error`, when it
// is no JSON or something is missing; the truth (pose, trans, gt, mask) is not looked at.
bool ParseRaFlowPair(std::string_view text, RaFlowPair* pair, std::string* error);

// The poses of the two scans in such a file: T_world_radar, rows of `pose` in pc1 and pc2. The
// world is local; its z axis points the other way than the radar's. False, with the key and the
// expectation in `error`, when one of them is no rigid transform.
bool ParseRaFlowPoses(std::string_view text,
                      MatrixPose* T_world_first,
                      MatrixPose* T_world_second,
                      std::string* error);

}  // namespace radive
