// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radive/evaluation/association.h"
#include "radive/evaluation/pose_relation.h"

namespace radive {

// Absolute pose errors, one for each pair of matched poses Q (reference) and P (estimate):
//
//   trans_part, point_distance   |p - q|
//   all others                   of E = P^-1 Q
//
// in the unit of the relation. Errors: a relation that is relative only, and angles of matrices
// that are no rotations. Both lists have the same length (checked).
std::optional<std::vector<double>> AbsolutePoseErrors(const MatchedPoses& poses,
                                                      PoseRelation relation,
                                                      std::string* error);

}  // namespace radive
