// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "radive/geometry/matrix_pose.h"

namespace radive {

// What of a pose difference E counts as the error.
enum class PoseRelation {
  kTransPart,           // length of the translation of E                            [m]
  kAngleDeg,            // rotation angle of E, 0 to 180                             [deg]
  kAngleRad,            // rotation angle of E, 0 to pi                              [rad]
  kRotPart,             // Frobenius norm of R_E - I                                 [-]
  kFull,                // Frobenius norm of E - I, metres and rotation mixed        [-]
  kPointDistance,       // APE: as kTransPart; RPE: difference of the distances gone [m]
  kPointDistanceRatio,  // RPE only: kPointDistance in per cent of the reference's   [%]
};

const char* UnitOf(PoseRelation relation);

// Angle [rad, 0 to pi] of a rotation matrix, accurate near 0 and near pi, where the arc cosine of
// the trace is not. The matrix need not be perfectly orthonormal.
double RotationAngle(const Eigen::Matrix3d& R);

// True when determinant and R^T R are 1 to about 1e-5, as evo demands before it takes an angle.
bool IsRotation(const Eigen::Matrix3d& R);

// The error of a pose difference E. std::nullopt for the angles of an E that is no rotation.
// kPointDistanceRatio is no function of E (a programmer's error).
std::optional<double> MeasureError(const MatrixPose& E, PoseRelation relation);

// The message for that: which pose, and what was expected.
std::string NotARotationMessage(std::size_t pose_index);

}  // namespace radive
