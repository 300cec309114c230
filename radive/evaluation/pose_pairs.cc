// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/pose_pairs.h"

#include <cmath>

#include "radive/evaluation/nearest_value.h"
#include "radive/evaluation/path_length.h"
#include "radive/evaluation/pose_relation.h"
#include "radive/util/angle_units.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

// Pairs further from delta than this share of it are dropped when all pairs are wanted.
constexpr double kRelativeTolerance = 0.1;

std::vector<PosePair> FramePairs(std::size_t num_poses, std::size_t delta, bool all_pairs) {
  std::vector<PosePair> pairs;
  const std::size_t step = all_pairs ? 1 : delta;
  for (std::size_t i = 0; i + delta < num_poses; i += step) pairs.emplace_back(i, i + delta);
  return pairs;
}

std::vector<PosePair> ConsecutiveMetrePairs(const std::vector<MatrixPose>& poses, double delta) {
  std::vector<PosePair> pairs;
  std::optional<std::size_t> anchor;
  double walked = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    walked += (poses[i].translation - poses[i - 1].translation).norm();
    if (walked < delta) continue;
    if (anchor) pairs.emplace_back(*anchor, i);
    anchor = i;
    walked = 0.0;
  }
  return pairs;
}

std::vector<PosePair> AllMetrePairs(const std::vector<MatrixPose>& poses, double delta) {
  std::vector<PosePair> pairs;
  const std::vector<double> path = PathLengths(poses);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double target = path[i] + delta;
    const std::size_t j = NearestAscending(path, i + 1, target);
    if (std::abs(path[j] - target) <= kRelativeTolerance * delta) pairs.emplace_back(i, j);
  }
  return pairs;
}

double AngleBetween(const MatrixPose& a, const MatrixPose& b) {
  return RotationAngle(a.rotation.transpose() * b.rotation);
}

// `delta` and the angles are multiples of `unit` [rad].
std::vector<PosePair> ConsecutiveAnglePairs(const std::vector<MatrixPose>& poses,
                                            double delta,
                                            double unit) {
  std::vector<PosePair> pairs;
  std::size_t start = 0;
  double turned = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    turned += AngleBetween(poses[i - 1], poses[i]) / unit;
    if (turned < delta) continue;
    pairs.emplace_back(start, i);
    start = i;
    turned = 0.0;
  }
  return pairs;
}

std::vector<PosePair> AllAnglePairs(const std::vector<MatrixPose>& poses,
                                    double delta,
                                    double unit) {
  std::vector<PosePair> pairs;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t j = i + 1; j < poses.size(); ++j) {
      const double angle = AngleBetween(poses[i], poses[j]) / unit;
      const double tolerance = kRelativeTolerance * delta;
      if (angle >= delta - tolerance && angle <= delta + tolerance) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

std::vector<PosePair> PairsByUnit(const std::vector<MatrixPose>& poses,
                                  const PosePairOptions& options) {
  const double delta = options.delta;
  switch (options.delta_unit) {
    case DeltaUnit::kFrames:
      return FramePairs(poses.size(), static_cast<std::size_t>(delta), options.all_pairs);
    case DeltaUnit::kMetres:
      return options.all_pairs ? AllMetrePairs(poses, delta) : ConsecutiveMetrePairs(poses, delta);
    case DeltaUnit::kDegrees:
    case DeltaUnit::kRadians:
      break;
  }
  const double unit = options.delta_unit == DeltaUnit::kDegrees ? Radians(1.0) : 1.0;
  return options.all_pairs ? AllAnglePairs(poses, delta, unit)
                           : ConsecutiveAnglePairs(poses, delta, unit);
}

}  // namespace

std::vector<OptionField> PosePairOptions::Fields() {
  return {
      OptionField{"delta", &delta, "delta_unit", "Distance of the two poses of a pair."}
          .Above(0.0)
          .AtMost(1e9),
      {"delta_unit",
       MakeChoice(&delta_unit, {"f", "m", "deg", "rad"}),
       "-",
       "Unit of delta: frames, metres of path, degrees or radians of rotation."},
      {"all_pairs", &all_pairs, "-", "Every pose starts a pair."},
  };
}

bool PosePairOptions::IsValid(std::string* error) const {
  if (!CheckOptions("rpe", *this, error)) return false;
  if (delta_unit == DeltaUnit::kFrames && (delta < 1.0 || delta != std::floor(delta))) {
    *error = "rpe.delta must be a whole number >= 1 in frames, is " + NumberText(delta);
    return false;
  }
  return true;
}

std::optional<std::vector<PosePair>> SelectPosePairs(const std::vector<MatrixPose>& poses,
                                                     const PosePairOptions& options,
                                                     std::string* error) {
  if (!options.IsValid(error)) return std::nullopt;
  const bool needs_angles = options.delta_unit == DeltaUnit::kDegrees ||  //
                            options.delta_unit == DeltaUnit::kRadians;
  for (std::size_t i = 0; needs_angles && i < poses.size(); ++i) {
    if (!IsRotation(poses[i].rotation)) {
      *error = NotARotationMessage(i);
      return std::nullopt;
    }
  }
  std::vector<PosePair> pairs = PairsByUnit(poses, options);
  if (pairs.empty()) {
    static const char* const kUnits[] = {"frames", "m", "deg", "rad"};
    *error = "no two of the " + std::to_string(poses.size()) + " matched poses are " +
             NumberText(options.delta) + " " + kUnits[static_cast<int>(options.delta_unit)] +
             " apart; choose a smaller delta";
    return std::nullopt;
  }
  return pairs;
}

}  // namespace radive
