// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/absolute_pose_error.h"

#include <glog/logging.h>

namespace radive {

std::optional<std::vector<double>> AbsolutePoseErrors(const MatchedPoses& poses,
                                                      PoseRelation relation,
                                                      std::string* error) {
  CHECK_EQ(poses.reference.size(), poses.estimate.size());
  if (relation == PoseRelation::kPointDistanceRatio) {
    *error = "the distance ratio compares pairs of poses: expected metric rpe, found ape";
    return std::nullopt;
  }
  const bool positions_only =
      relation == PoseRelation::kTransPart || relation == PoseRelation::kPointDistance;
  std::vector<double> errors;
  errors.reserve(poses.reference.size());
  for (std::size_t i = 0; i < poses.reference.size(); ++i) {
    const MatrixPose& Q = poses.reference[i];
    const MatrixPose& P = poses.estimate[i];
    if (positions_only) {
      errors.push_back((P.translation - Q.translation).norm());
      continue;
    }
    const std::optional<double> value = MeasureError(Between(P, Q), relation);
    if (!value) {
      *error = NotARotationMessage(i);
      return std::nullopt;
    }
    errors.push_back(*value);
  }
  return errors;
}

}  // namespace radive
