// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "radive/geometry/matrix_pose.h"

namespace radive {

enum class AlignmentMode {
  kNone,
  kSe3,        // rotation and translation that minimise the squared distances of the positions
  kSim3,       // the same with a scale
  kScaleOnly,  // the scale of kSim3 alone
  kOrigin,     // the first estimated pose onto the first reference pose
};

// A similarity p_reference = scale * rotation * p_estimate + translation.
struct Alignment {
  double scale = 1.0;  // [-]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  // [m]
};

// Alignment of matched poses. The modes that fit use the first `first_n` pairs, all of them when
// first_n is 0 or larger than their number. An error when the positions used do not fix a
// rotation: fewer than two directions of motion, for example a standing or a straight track.
// Both lists have the same length (checked), at least 1.
// Source: Umeyama, "Least-squares estimation of transformation parameters between two point
// patterns", PAMI 1991, Eq. (34) to (43).
std::optional<Alignment> ComputeAlignment(AlignmentMode mode,
                                          const std::vector<MatrixPose>& reference,
                                          const std::vector<MatrixPose>& estimate,
                                          int first_n,
                                          std::string* error);

// Maps every pose: the position by the similarity, the attitude by its rotation.
void ApplyAlignment(const Alignment& alignment, std::vector<MatrixPose>* poses);

}  // namespace radive
