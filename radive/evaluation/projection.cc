// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/projection.h"

#include <cmath>
#include <limits>

namespace radive {
namespace {

Eigen::Matrix3d RotationAbout(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

// The part of R that stays in the plane.
Eigen::Matrix3d PlanarRotation(Plane plane, const Eigen::Matrix3d& R) {
  const double cos_pitch = std::hypot(R(0, 0), R(1, 0));
  const bool gimbal_lock = cos_pitch <= 4.0 * std::numeric_limits<double>::epsilon();
  switch (plane) {
    case Plane::kXy:
      return RotationAbout(Eigen::Vector3d::UnitZ(),
                           gimbal_lock ? 0.0 : std::atan2(R(1, 0), R(0, 0)));
    case Plane::kXz:
      return RotationAbout(Eigen::Vector3d::UnitY(), std::atan2(-R(2, 0), cos_pitch));
    case Plane::kYz:
      // In gimbal lock the whole of yaw and roll counts as roll.
      return RotationAbout(
          Eigen::Vector3d::UnitX(),
          gimbal_lock ? std::atan2(-R(1, 2), R(1, 1)) : std::atan2(R(2, 1), R(2, 2)));
    case Plane::kNone:
      break;
  }
  return R;
}

}  // namespace

void ProjectToPlane(Plane plane, std::vector<MatrixPose>* poses) {
  if (plane == Plane::kNone) return;
  const int normal = plane == Plane::kXy ? 2 : plane == Plane::kXz ? 1 : 0;
  for (MatrixPose& pose : *poses) {
    pose.translation[normal] = 0.0;
    pose.rotation = PlanarRotation(plane, pose.rotation);
  }
}

}  // namespace radive
