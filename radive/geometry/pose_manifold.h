// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/manifold.h>
#include <ceres/product_manifold.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>

#include "radive/geometry/plane_basis.h"
#include "radive/geometry/rigid3.h"

namespace radive {

// Full 6-DoF manifold of the pose block [qx qy qz qw tx ty tz]. Tangent: [a (3), dt (3)], where
// the rotation is multiplied from the left by exp(2 a): Ceres' quaternion manifold takes HALF the
// rotation vector.
using PoseManifold =
    ceres::ProductManifold<ceres::EigenQuaternionManifold, ceres::EuclideanManifold<3>>;

// Poses that differ by a motion in a plane: rotation about `normal` and translation across it.
// Tangent: [angle [rad], two translations along an orthonormal basis of the plane [m]]. The frame
// is that of the pose's left side (p_a of T_a_b).
class PlanarPoseManifold : public ceres::Manifold {
 public:
  explicit PlanarPoseManifold(const Eigen::Vector3d& normal)
      : normal_(normal.normalized()), basis_(PlaneBasis(normal_)) {}

  int AmbientSize() const override { return 7; }
  int TangentSize() const override { return 3; }

  bool Plus(const double* x, const double* delta, double* x_plus_delta) const override {
    const Eigen::Map<const Eigen::Quaterniond> q(x);
    const Eigen::Map<const Eigen::Vector3d> t(x + 4);
    Eigen::Map<Eigen::Quaterniond> q_out(x_plus_delta);
    Eigen::Map<Eigen::Vector3d> t_out(x_plus_delta + 4);
    q_out = Eigen::Quaterniond(Eigen::AngleAxisd(delta[0], normal_)) * q;
    t_out = t + basis_ * Eigen::Map<const Eigen::Vector2d>(delta + 1);
    return true;
  }

  bool PlusJacobian(const double* x, double* jacobian) const override {
    Eigen::Map<Eigen::Matrix<double, 7, 3, Eigen::RowMajor>> j(jacobian);
    j.setZero();
    // d/d(angle) of exp(angle n) q at 0 is the quaternion product (n / 2, 0) q.
    const Eigen::Map<const Eigen::Quaterniond> q(x);
    const Eigen::Quaterniond half(0.0, 0.5 * normal_.x(), 0.5 * normal_.y(), 0.5 * normal_.z());
    j.block<4, 1>(0, 0) = (half * q).coeffs();
    j.block<3, 2>(4, 1) = basis_;
    return true;
  }

  bool Minus(const double* y, const double* x, double* y_minus_x) const override {
    const Eigen::Map<const Eigen::Quaterniond> q_y(y), q_x(x);
    const Eigen::Map<const Eigen::Vector3d> t_y(y + 4), t_x(x + 4);
    y_minus_x[0] = normal_.dot(RotationVector(q_y * q_x.conjugate()));
    Eigen::Map<Eigen::Vector2d> planar(y_minus_x + 1);
    planar = basis_.transpose() * (t_y - t_x);
    return true;
  }

  bool MinusJacobian(const double* x, double* jacobian) const override {
    Eigen::Matrix<double, 7, 3, Eigen::RowMajor> plus;
    PlusJacobian(x, plus.data());
    // The columns of the Plus Jacobian are orthogonal; that of the angle has length 1/2.
    Eigen::Map<Eigen::Matrix<double, 3, 7, Eigen::RowMajor>> j(jacobian);
    j = plus.transpose();
    j.row(0) *= 4.0;
    return true;
  }

 private:
  Eigen::Vector3d normal_;
  Eigen::Matrix<double, 3, 2> basis_;
};

}  // namespace radive
