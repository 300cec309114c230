// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/problem.h>

#include <Eigen/Core>
#include <optional>

namespace radive {

// Covariance of one parameter block at the current point of `problem`, all other free blocks
// marginalised: the pseudo-inverse of J'J by dense singular value decomposition. It is the
// covariance of the estimate when the residuals are whitened (unit variance) and independent.
//
// Rows and columns are those of the block's tangent space: the block's own coordinates where it has
// no manifold, otherwise the `delta` of its manifold's Plus(). For ceres::EigenQuaternionManifold
// delta is HALF the rotation vector, applied on the left: Plus(q, delta) = exp(2 delta) q, so a
// covariance in rad^2 is the one returned here times 4 (times 2 in the cross terms with blocks
// that are no rotations). See RotationVectorCovariance() for pose blocks.
//
// Directions that J leaves unobserved (singular value below 1e-7 of the largest) get zero variance,
// as the pseudo-inverse has it: check observability apart. None when the block is constant or not
// in the problem, or when an evaluation fails.
std::optional<Eigen::MatrixXd> MarginalCovariance(ceres::Problem* problem, const double* block);

// The same for the tangent space [half rotation vector (3), translation (3)] of the pose blocks
// (rotation first: geometry/rigid3.h): turns the half angles into rotation vectors. Units
// [rad^2, rad m, m^2]; the true pose is (exp(dr) R, t + dt).
Eigen::MatrixXd RotationVectorCovariance(const Eigen::MatrixXd& tangent_covariance);

}  // namespace radive
