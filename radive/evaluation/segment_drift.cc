// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/segment_drift.h"

#include <glog/logging.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "radive/evaluation/path_length.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr int kNumLengths = 8;
constexpr double kLengthStep = 100.0;  // [m]

// The benchmark inverts the 3x4 matrices instead of transposing their rotations, and takes the arc
// cosine of the trace. With rotations of seven digits this changes the mean rotation by 0.1 %.
MatrixPose BenchmarkBetween(const MatrixPose& T_a_b, const MatrixPose& T_a_c) {
  const Eigen::Matrix3d R_b_a = T_a_b.rotation.inverse();
  return {R_b_a * T_a_c.rotation, R_b_a * (T_a_c.translation - T_a_b.translation)};
}

double BenchmarkAngle(const Eigen::Matrix3d& R) {
  return std::acos(std::clamp(0.5 * (R.trace() - 1.0), -1.0, 1.0));
}

}  // namespace

std::optional<SegmentDrift> ComputeSegmentDrift(const MatchedPoses& poses,
                                                int step,
                                                std::string* error) {
  CHECK_GE(step, 1);
  const std::vector<double> path = PathLengths(poses.reference);
  SegmentDrift drift;
  for (std::size_t i = 0; i < path.size(); i += static_cast<std::size_t>(step)) {
    for (int k = 1; k <= kNumLengths; ++k) {
      const double length = k * kLengthStep;
      const auto end = std::upper_bound(path.begin(), path.end(), path[i] + length);
      if (end == path.end()) break;
      const std::size_t j = static_cast<std::size_t>(end - path.begin());
      const MatrixPose P_ij = BenchmarkBetween(poses.estimate[i], poses.estimate[j]);
      const MatrixPose Q_ij = BenchmarkBetween(poses.reference[i], poses.reference[j]);
      const MatrixPose E = BenchmarkBetween(P_ij, Q_ij);
      drift.segments.push_back({static_cast<int>(i),
                                length,
                                E.translation.norm() / length,
                                BenchmarkAngle(E.rotation) / length});
    }
  }
  if (drift.segments.empty()) {
    *error = "segment errors need more than 100 m of matched reference path, found " +
             NumberText(path.empty() ? 0.0 : path.back()) + " m";
    return std::nullopt;
  }
  for (const SegmentError& segment : drift.segments) {
    drift.translation += segment.translation;
    drift.rotation += segment.rotation;
  }
  drift.translation /= static_cast<double>(drift.segments.size());
  drift.rotation /= static_cast<double>(drift.segments.size());
  return drift;
}

}  // namespace radive
