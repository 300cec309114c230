// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "radive/geometry/rigid3.h"

namespace radive {

// A pose T_a_b whose rotation is kept as the 3x3 matrix that a file holds, rounding errors
// included. Files with seven digits are orthonormal to 1e-7 only; evo takes them as they are, and
// over hundreds of metres a cleaned matrix gives other errors than evo's. For everything but
// evaluation use Rigid3.
struct MatrixPose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  // [m]

  MatrixPose() = default;
  MatrixPose(const Eigen::Matrix3d& R, const Eigen::Vector3d& t) : rotation(R), translation(t) {}
  explicit MatrixPose(const Rigid3& T) : rotation(T.RotationMatrix()), translation(T.translation) {}

  Rigid3 ToRigid3() const { return {Eigen::Quaterniond(rotation), translation}; }
};

// T_a_c = T_a_b * T_b_c.
inline MatrixPose operator*(const MatrixPose& T_a_b, const MatrixPose& T_b_c) {
  return {T_a_b.rotation * T_b_c.rotation, T_a_b.rotation * T_b_c.translation + T_a_b.translation};
}

// T_a_b^-1 * T_a_c, with the transpose as the inverse rotation. Subtracts before it rotates, so
// that map coordinates of millions of metres cost no digits.
inline MatrixPose Between(const MatrixPose& T_a_b, const MatrixPose& T_a_c) {
  return {T_a_b.rotation.transpose() * T_a_c.rotation,
          T_a_b.rotation.transpose() * (T_a_c.translation - T_a_b.translation)};
}

}  // namespace radive
