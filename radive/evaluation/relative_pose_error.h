// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radive/evaluation/association.h"
#include "radive/evaluation/pose_pairs.h"
#include "radive/evaluation/pose_relation.h"

namespace radive {

// Relative pose errors, one for each pair (i, j) of matched poses Q (reference), P (estimate):
//
//   point_distance         | |q_j - q_i| - |p_j - p_i| |
//   point_distance_ratio   the same in per cent of |q_j - q_i|; pairs that stand still in the
//                          reference are left out
//   all others             of E = (Q_i^-1 Q_j)^-1 (P_i^-1 P_j)
//
// in the unit of the relation. Errors: angles of matrices that are no rotations, and ratios when
// every pair stands still.
std::optional<std::vector<double>> RelativePoseErrors(const MatchedPoses& poses,
                                                      const std::vector<PosePair>& pairs,
                                                      PoseRelation relation,
                                                      std::string* error);

}  // namespace radive
