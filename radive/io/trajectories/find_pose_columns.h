// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "radive/io/trajectories/pose_table.h"

namespace radive {

// Which columns of a text table of poses hold what.
//
// Where a line in front of the numbers has a name for each column (a comment may), the names
// decide: a stamp (timestamp, time, t ..., seconds and nanoseconds apart), x y z (tx, px,
// position.x ...) and a rotation: qx qy qz qw in any order (orientation.x ...), roll pitch yaw, or
// r00 to r22. Units may follow: "yaw [deg]", "timestamp_us".
//
// Otherwise the numbers of all lines decide:
//    7  x y z qx qy qz qw, if that has length 1
//    8  t x y z qx qy qz qw
//   12  rows of [R | t]; with other columns in front: of the index, the stamp, or both
//   16  rows of a 4x4 matrix with the last row 0 0 0 1, or its columns; likewise
//   9 and more  t x y z, or index t x y z, and the first four columns in a row behind that have
//       length 1 in all lines: qx qy qz qw
// A first column that counts 0 1 2 ... or 1 2 3 ... in front of matrices is an index: no stamps.
// Decimal commas are read where semicolons, tabs or blanks separate the columns.
//
// Nothing, with the reason and what to set in `error`, when that does not tell.
std::optional<PoseColumns> FindPoseColumns(std::string_view text,
                                           const std::string& place,
                                           std::string* error);

}  // namespace radive
