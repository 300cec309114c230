// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radive/geometry/matrix_pose.h"
#include "radive/util/option_field.h"

namespace radive {

enum class DeltaUnit { kFrames, kMetres, kDegrees, kRadians };

// Which pairs (i, j), i < j, relative errors look at.
struct PosePairOptions {
  // Distance of the two poses of a pair, in delta_unit: frames (whole), path length, or angle.
  double delta = 1.0;
  DeltaUnit delta_unit = DeltaUnit::kFrames;

  // Every pose starts a pair, instead of one pair after the other.
  bool all_pairs = false;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const;
};

using PosePair = std::pair<std::size_t, std::size_t>;

// Chooses pairs as evo does.
//
// frames   one after the other: (0, d), (d, 2 d), ...; all pairs: (i, i + d).
// metres   one after the other: the path is walked and a pose becomes an anchor whenever the steps
//          since the last anchor sum up to d; neighbouring anchors are pairs. Pose 0 is no anchor,
//          so the first stretch is not used. All pairs: for each i the later j whose path length
//          from i is nearest to d, if it is within 10 % of d.
// degrees, one after the other: the rotations from pose to pose are summed; (start, j) is a pair
// radians  when they reach d, and j the next start; pose 0 is the first start. All pairs: all
//          (i, j) whose direct rotation is within 10 % of d. Quadratic in the number of poses.
//
// Errors: bad options, rotations that are none (angles), and no pair at all.
std::optional<std::vector<PosePair>> SelectPosePairs(const std::vector<MatrixPose>& poses,
                                                     const PosePairOptions& options,
                                                     std::string* error);

}  // namespace radive
