// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace radive {

// A rigid transform T_a_b: p_a = T_a_b * p_b = rotation * p_b + translation.
// Neighbouring letters cancel in products: T_a_c = T_a_b * T_b_c.
struct Rigid3 {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // unit
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();         // [m]

  Rigid3() = default;
  Rigid3(const Eigen::Quaterniond& q, const Eigen::Vector3d& t)
      : rotation(q.normalized()), translation(t) {}

  Rigid3 Inverse() const {
    const Eigen::Quaterniond q = rotation.conjugate();
    return {q, -(q * translation)};
  }

  Eigen::Matrix3d RotationMatrix() const { return rotation.toRotationMatrix(); }
};

// The product is re-normalised, so that chains of any length stay rotations.
inline Rigid3 operator*(const Rigid3& T_a_b, const Rigid3& T_b_c) {
  return {T_a_b.rotation * T_b_c.rotation, T_a_b.rotation * T_b_c.translation + T_a_b.translation};
}

inline Eigen::Vector3d operator*(const Rigid3& T_a_b, const Eigen::Vector3d& p_b) {
  return T_a_b.rotation * p_b + T_a_b.translation;
}

// Exactly: no tolerance.
inline bool IsIdentity(const Rigid3& T) {
  return T.translation.isZero(0.0) && T.rotation.vec().isZero(0.0);
}

// Pose parameter block of all factors: [qx qy qz qw tx ty tz] (Eigen's coefficient order).
using PoseBlock = std::array<double, 7>;

inline PoseBlock ToPoseBlock(const Rigid3& T) {
  return {T.rotation.x(),
          T.rotation.y(),
          T.rotation.z(),
          T.rotation.w(),
          T.translation.x(),
          T.translation.y(),
          T.translation.z()};
}

inline Rigid3 FromPoseBlock(const PoseBlock& block) {
  return {Eigen::Quaterniond(block[3], block[0], block[1], block[2]),
          Eigen::Vector3d(block[4], block[5], block[6])};
}

// Rotation vector [rad] (axis times angle in [0, pi]) of a unit quaternion, accurate near zero.
inline Eigen::Vector3d RotationVector(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d v = sign * q.vec();
  const double sin_half = v.norm();
  if (sin_half < 1e-9) return 2.0 * v;
  return v * (2.0 * std::atan2(sin_half, sign * q.w()) / sin_half);
}

// Unit quaternion of a rotation vector [rad].
inline Eigen::Quaterniond QuaternionFromRotationVector(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  if (angle < 1e-9) {
    return Eigen::Quaterniond(
               1.0, 0.5 * rotation_vector.x(), 0.5 * rotation_vector.y(), 0.5 * rotation_vector.z())
        .normalized();
  }
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, rotation_vector / angle));
}

inline Eigen::Matrix3d Skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

}  // namespace radive
