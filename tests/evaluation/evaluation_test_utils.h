// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "radive/geometry/matrix_pose.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive::testing {

inline Eigen::Matrix3d Rotation(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

// Poses at these positions, all with identity rotation.
inline std::vector<MatrixPose> PosesAt(const std::vector<Eigen::Vector3d>& positions) {
  std::vector<MatrixPose> poses;
  for (const Eigen::Vector3d& p : positions) poses.emplace_back(Eigen::Matrix3d::Identity(), p);
  return poses;
}

// Poses along x.
inline std::vector<MatrixPose> PosesAlongX(const std::vector<double>& xs) {
  std::vector<MatrixPose> poses;
  for (const double x : xs) {
    poses.emplace_back(Eigen::Matrix3d::Identity(), Eigen::Vector3d(x, 0, 0));
  }
  return poses;
}

// Poses at the origin, turned about z by these angles [rad].
inline std::vector<MatrixPose> PosesTurned(const std::vector<double>& angles) {
  std::vector<MatrixPose> poses;
  for (const double angle : angles) {
    poses.emplace_back(Rotation(Eigen::Vector3d::UnitZ(), angle), Eigen::Vector3d::Zero());
  }
  return poses;
}

// A trajectory along x with x [m] = t [s].
inline RecordedTrajectory StampedAlongX(const std::vector<double>& stamps) {
  RecordedTrajectory trajectory;
  for (const double t : stamps) {
    trajectory.push_back({static_cast<std::int64_t>(t * 1e9),
                          t,
                          MatrixPose(Eigen::Matrix3d::Identity(), Eigen::Vector3d(t, 0, 0))});
  }
  return trajectory;
}

}  // namespace radive::testing
