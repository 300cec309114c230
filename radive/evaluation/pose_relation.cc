// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/pose_relation.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "radive/util/angle_units.h"

namespace radive {

const char* UnitOf(PoseRelation relation) {
  switch (relation) {
    case PoseRelation::kTransPart:
    case PoseRelation::kPointDistance:
      return "m";
    case PoseRelation::kAngleDeg:
      return "deg";
    case PoseRelation::kAngleRad:
      return "rad";
    case PoseRelation::kPointDistanceRatio:
      return "%";
    case PoseRelation::kRotPart:
    case PoseRelation::kFull:
      break;
  }
  return "-";
}

double RotationAngle(const Eigen::Matrix3d& R) {
  // Unit quaternion by Shepperd's method: divide by the largest of the four components. On a
  // matrix that is orthonormal to 1e-7 only, the choice decides the seventh digit of the angle;
  // this one is the same as in scipy, and so in evo.
  const double trace = R.trace();
  Eigen::Index axis = 0;
  const double largest = R.diagonal().maxCoeff(&axis);
  Eigen::Vector3d v;
  double w = 0.0;
  if (trace > largest) {
    v = Eigen::Vector3d(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
    w = 1.0 + trace;
  } else {
    const Eigen::Index j = (axis + 1) % 3;
    const Eigen::Index k = (axis + 2) % 3;
    v[axis] = 1.0 - trace + 2.0 * largest;
    v[j] = R(j, axis) + R(axis, j);
    v[k] = R(k, axis) + R(axis, k);
    w = R(k, j) - R(j, k);
  }
  return 2.0 * std::atan2(v.norm(), std::abs(w));
}

bool IsRotation(const Eigen::Matrix3d& R) {
  constexpr double kAbsolute = 1e-6;
  constexpr double kRelative = 1e-5;
  const Eigen::Matrix3d deviation = R.transpose() * R - Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d allowed =
      Eigen::Matrix3d::Constant(kAbsolute) + kRelative * Eigen::Matrix3d::Identity();
  return std::abs(R.determinant() - 1.0) <= kAbsolute + kRelative &&
         (deviation.array().abs() <= allowed.array()).all();
}

std::optional<double> MeasureError(const MatrixPose& E, PoseRelation relation) {
  const Eigen::Matrix3d rotation_part = E.rotation - Eigen::Matrix3d::Identity();
  switch (relation) {
    case PoseRelation::kTransPart:
    case PoseRelation::kPointDistance:
      return E.translation.norm();
    case PoseRelation::kRotPart:
      return rotation_part.norm();
    case PoseRelation::kFull:
      return std::hypot(rotation_part.norm(), E.translation.norm());
    case PoseRelation::kAngleDeg:
    case PoseRelation::kAngleRad:
      if (!IsRotation(E.rotation)) return std::nullopt;
      return relation == PoseRelation::kAngleRad ? RotationAngle(E.rotation)
                                                 : Degrees(RotationAngle(E.rotation));
    case PoseRelation::kPointDistanceRatio:
      break;
  }
  LOG(FATAL) << "a distance ratio is no function of one pose difference";
  return std::nullopt;
}

std::string NotARotationMessage(std::size_t pose_index) {
  return "matched pose " + std::to_string(pose_index) +
         ": expected rotation matrices that are orthonormal to 1e-6, as angles need them";
}

}  // namespace radive
