// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/alignment.h"

#include <glog/logging.h>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>

namespace radive {
namespace {

Eigen::Matrix3Xd Positions(const std::vector<MatrixPose>& poses, Eigen::Index count) {
  Eigen::Matrix3Xd positions(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    positions.col(i) = poses[static_cast<std::size_t>(i)].translation;
  }
  return positions;
}

std::optional<Alignment> FitSimilarity(const Eigen::Matrix3Xd& reference,
                                       const Eigen::Matrix3Xd& estimate,
                                       bool with_scale,
                                       std::string* error) {
  // Centred first: products of map coordinates would leave no digits for the motion.
  const double n = static_cast<double>(reference.cols());
  const Eigen::Vector3d reference_mean = reference.rowwise().mean();
  const Eigen::Vector3d estimate_mean = estimate.rowwise().mean();
  const Eigen::Matrix3Xd reference_centred = reference.colwise() - reference_mean;
  const Eigen::Matrix3Xd estimate_centred = estimate.colwise() - estimate_mean;

  const Eigen::Matrix3d covariance =
      reference_centred * estimate_centred.transpose() / n;  // Eq. (38)
  // A square matrix needs no QR decomposition first, and its code takes long to compile.
  const Eigen::JacobiSVD<Eigen::Matrix3d, Eigen::NoQRPreconditioner> svd(
      covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.singularValues()(1) <= std::numeric_limits<double>::epsilon()) {
    *error = "alignment needs at least two directions of motion; the " +
             std::to_string(reference.cols()) + " matched positions do not fix a rotation";
    return std::nullopt;
  }
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();  // Eq. (43)
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) signs.z() = -1.0;

  Alignment alignment;
  alignment.rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();  // Eq. (40)
  if (with_scale) {
    alignment.scale =
        svd.singularValues().dot(signs) / (estimate_centred.squaredNorm() / n);  // Eq. (42)
  }
  alignment.translation =
      reference_mean - alignment.scale * (alignment.rotation * estimate_mean);  // Eq. (41)
  return alignment;
}

}  // namespace

std::optional<Alignment> ComputeAlignment(AlignmentMode mode,
                                          const std::vector<MatrixPose>& reference,
                                          const std::vector<MatrixPose>& estimate,
                                          int first_n,
                                          std::string* error) {
  CHECK_EQ(reference.size(), estimate.size());
  CHECK(!reference.empty());
  if (mode == AlignmentMode::kNone) return Alignment();
  if (mode == AlignmentMode::kOrigin) {
    // Q_0 P_0^-1, with the transpose as inverse.
    Alignment alignment;
    alignment.rotation = reference[0].rotation * estimate[0].rotation.transpose();
    alignment.translation = reference[0].translation - alignment.rotation * estimate[0].translation;
    return alignment;
  }
  const Eigen::Index total = static_cast<Eigen::Index>(reference.size());
  const Eigen::Index count = first_n > 0 ? std::min<Eigen::Index>(first_n, total) : total;
  std::optional<Alignment> alignment = FitSimilarity(
      Positions(reference, count), Positions(estimate, count), mode != AlignmentMode::kSe3, error);
  if (alignment && mode == AlignmentMode::kScaleOnly) {
    alignment = Alignment{alignment->scale, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
  }
  return alignment;
}

void ApplyAlignment(const Alignment& alignment, std::vector<MatrixPose>* poses) {
  const MatrixPose T_reference_estimate(alignment.rotation, alignment.translation);
  for (MatrixPose& pose : *poses) {
    pose.translation *= alignment.scale;
    pose = T_reference_estimate * pose;
  }
}

}  // namespace radive
