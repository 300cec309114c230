// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/relative_pose_error.h"

#include <cmath>

namespace radive {
namespace {

double DistanceBetween(const std::vector<MatrixPose>& poses, const PosePair& pair) {
  return (poses[pair.second].translation - poses[pair.first].translation).norm();
}

std::optional<std::vector<double>> DistanceErrors(const MatchedPoses& poses,
                                                  const std::vector<PosePair>& pairs,
                                                  bool as_ratio,
                                                  std::string* error) {
  std::vector<double> errors;
  errors.reserve(pairs.size());
  for (const PosePair& pair : pairs) {
    const double reference = DistanceBetween(poses.reference, pair);
    const double difference = std::abs(reference - DistanceBetween(poses.estimate, pair));
    if (as_ratio && reference == 0.0) continue;
    errors.push_back(as_ratio ? 100.0 * difference / reference : difference);
  }
  if (errors.empty()) {
    *error = "the reference stands still in all " + std::to_string(pairs.size()) +
             " pairs; a distance ratio needs motion";
    return std::nullopt;
  }
  return errors;
}

}  // namespace

std::optional<std::vector<double>> RelativePoseErrors(const MatchedPoses& poses,
                                                      const std::vector<PosePair>& pairs,
                                                      PoseRelation relation,
                                                      std::string* error) {
  if (relation == PoseRelation::kPointDistance || relation == PoseRelation::kPointDistanceRatio) {
    return DistanceErrors(poses, pairs, relation == PoseRelation::kPointDistanceRatio, error);
  }
  std::vector<double> errors;
  errors.reserve(pairs.size());
  for (const auto& [i, j] : pairs) {
    const MatrixPose Q_ij = Between(poses.reference[i], poses.reference[j]);
    const MatrixPose P_ij = Between(poses.estimate[i], poses.estimate[j]);
    const std::optional<double> value = MeasureError(Between(Q_ij, P_ij), relation);
    if (!value) {
      *error = NotARotationMessage(j);
      return std::nullopt;
    }
    errors.push_back(*value);
  }
  return errors;
}

}  // namespace radive
