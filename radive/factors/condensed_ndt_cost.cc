// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/factors/condensed_ndt_cost.h"

#include <ceres/jet.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

#include "radive/factors/ndt_pair_factor.h"
#include "radive/geometry/rigid3.h"

namespace radive {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// Inverse and determinant of a symmetric 3x3 matrix.
struct SymmetricInverse {
  double xx, xy, xz, yy, yz, zz;
  double determinant;

  SymmetricInverse(double a, double b, double c, double d, double e, double f) {
    // [a b c; b d e; c e f]
    const double m00 = d * f - e * e;
    const double m01 = c * e - b * f;
    const double m02 = b * e - c * d;
    determinant = a * m00 + b * m01 + c * m02;
    const double inverse = 1.0 / determinant;
    xx = m00 * inverse;
    xy = m01 * inverse;
    xz = m02 * inverse;
    yy = (a * f - c * c) * inverse;
    yz = (b * c - a * e) * inverse;
    zz = (a * d - b * b) * inverse;
  }

  Eigen::Vector3d operator*(const Eigen::Vector3d& v) const {
    return {xx * v.x() + xy * v.y() + xz * v.z(),
            xy * v.x() + yy * v.y() + yz * v.z(),
            xz * v.x() + yz * v.y() + zz * v.z()};
  }

  Eigen::Matrix3d Matrix() const {
    Eigen::Matrix3d m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
  }
};

// A scan Gaussian at the current pose.
struct Rotated {
  Eigen::Vector3d offset;      // R mu_A: the lever of the rotation
  Eigen::Vector3d mean;        // R mu_A + t
  Eigen::Matrix3d covariance;  // R Sigma_A R^T

  Rotated(const Gaussian3& gaussian, const Eigen::Matrix3d& R, const Eigen::Vector3d& t)
      : offset(R * gaussian.mean),
        mean(offset + t),
        covariance(R * gaussian.covariance * R.transpose()) {}
};

template <typename Target>
SymmetricInverse SigmaInverse(const Eigen::Matrix3d& a, const Target& b) {
  return {a(0, 0) + b.xx,
          a(0, 1) + b.xy,
          a(0, 2) + b.xz,
          a(1, 1) + b.yy,
          a(1, 2) + b.yz,
          a(2, 2) + b.zz};
}

// H += J^T stiffness J with J = [-[R mu_A]_x, I], but for its lower left block.
void AddAtLever(const Eigen::Matrix3d& stiffness, const Eigen::Matrix3d& lever, Matrix6d* H) {
  const Eigen::Matrix3d cross = lever * stiffness;
  H->topLeftCorner<3, 3>() += cross * lever.transpose();
  H->topRightCorner<3, 3>() += cross;
  H->bottomRightCorner<3, 3>() += stiffness;
}

void Symmetrise(Matrix6d* H) {
  H->bottomLeftCorner<3, 3>() = H->topRightCorner<3, 3>().transpose();
}

// Beyond this squared Mahalanobis distance a pair has no more than 1e-13 of its weight: its cost is
// the full depth and its derivatives are zero to rounding.
constexpr double kFarAway = 60.0;

}  // namespace

CondensedNdtCost::CondensedNdtCost(const std::vector<Gaussian3>& scan,
                                   const std::vector<Gaussian3>& submap,
                                   const std::vector<NdtPair>& pairs,
                                   const Eigen::Vector3d& origin,
                                   NdtNormalisation normalisation,
                                   NdtDerivatives derivatives)
    : scan_(scan),
      submap_(submap),
      pairs_(pairs),
      origin_(origin),
      normalisation_(normalisation),
      derivatives_(derivatives) {
  targets_.reserve(pairs.size());
  for (const NdtPair& pair : pairs) {
    const Gaussian3& a = scan[static_cast<std::size_t>(pair.scan)];
    const Gaussian3& b = submap[static_cast<std::size_t>(pair.submap)];
    Target target;
    target.mean = b.mean - origin;
    target.xx = b.covariance(0, 0);
    target.xy = b.covariance(0, 1);
    target.xz = b.covariance(0, 2);
    target.yy = b.covariance(1, 1);
    target.yz = b.covariance(1, 2);
    target.zz = b.covariance(2, 2);
    const double weight = a.weight * b.confidence;
    target.depth = weight;
    target.factor = weight;
    if (normalisation == NdtNormalisation::kPaper) {
      constexpr double kTwoPiCubed = 248.05021344239853;
      const double bound = NdtPairFactor::DeterminantBound(a.covariance, b.covariance);
      target.depth = weight / std::sqrt(kTwoPiCubed * bound);
      target.factor = weight / std::sqrt(kTwoPiCubed);
    }
    offset_ += target.depth;
    targets_.push_back(target);
  }
}

double CondensedNdtCost::Cost(const double* pose) const {
  const Eigen::Matrix3d R = Eigen::Map<const Eigen::Quaterniond>(pose).toRotationMatrix();
  const Eigen::Map<const Eigen::Vector3d> t(pose + 4);
  double cost = 0.0;
  std::size_t k = 0;
  while (k < pairs_.size()) {
    const int index = pairs_[k].scan;
    const Rotated a(scan_[static_cast<std::size_t>(index)], R, t);
    for (; k < pairs_.size() && pairs_[k].scan == index; ++k) {
      const Target& b = targets_[k];
      const Eigen::Vector3d delta = a.mean - b.mean;
      const SymmetricInverse inverse = SigmaInverse(a.covariance, b);
      const double m = delta.dot(inverse * delta);
      double height = b.factor;
      if (normalisation_ == NdtNormalisation::kPaper) height /= std::sqrt(inverse.determinant);
      cost += b.depth - (m < kFarAway ? height * std::exp(-0.5 * m) : 0.0);
    }
  }
  return cost;
}

NdtQuadratic CondensedNdtCost::AnalyticQuadratic(const double* pose, bool with_scatter) const {
  const Eigen::Matrix3d R = Eigen::Map<const Eigen::Quaterniond>(pose).toRotationMatrix();
  const Eigen::Map<const Eigen::Vector3d> t(pose + 4);
  NdtQuadratic result;
  std::size_t k = 0;
  while (k < pairs_.size()) {
    const int index = pairs_[k].scan;
    const Rotated a(scan_[static_cast<std::size_t>(index)], R, t);
    const Eigen::Matrix3d& G = a.covariance;
    // All pairs of one scan Gaussian share the lever R mu_A, so their sums are formed in 3D first.
    Eigen::Vector3d force = Eigen::Vector3d::Zero();       // sum of p q
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();      // of the covariance terms
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();   // sum of p Sigma^-1
    Eigen::Matrix3d off_centre = Eigen::Matrix3d::Zero();  // sum of p q q^T
    for (; k < pairs_.size() && pairs_[k].scan == index; ++k) {
      const Target& b = targets_[k];
      const Eigen::Vector3d delta = a.mean - b.mean;
      const SymmetricInverse inverse = SigmaInverse(G, b);
      const Eigen::Vector3d q = inverse * delta;
      const double m = delta.dot(q);
      result.cost += b.depth;
      if (!(m < kFarAway)) continue;
      double p = b.factor * std::exp(-0.5 * m);
      if (normalisation_ == NdtNormalisation::kPaper) p /= std::sqrt(inverse.determinant);
      result.cost -= p;
      force += p * q;
      torque -= p * (G * q).cross(q);
      const Eigen::Matrix3d inverse_matrix = inverse.Matrix();
      if (normalisation_ == NdtNormalisation::kPaper) {
        const Eigen::Matrix3d X = G * inverse_matrix;
        torque += p * Eigen::Vector3d(X(1, 2) - X(2, 1), X(2, 0) - X(0, 2), X(0, 1) - X(1, 0));
      }
      stiffness += p * inverse_matrix;
      if (with_scatter) off_centre += p * q * q.transpose();
    }
    Vector6d gradient;
    gradient.head<3>() = a.offset.cross(force) + torque;
    gradient.tail<3>() = force;
    result.gradient += gradient;
    const Eigen::Matrix3d lever = Skew(a.offset);
    AddAtLever(stiffness, lever, &result.hessian);
    if (with_scatter) {
      result.scatter += gradient * gradient.transpose();
      AddAtLever(stiffness - off_centre, lever, &result.curvature);
    }
  }
  Symmetrise(&result.hessian);
  Symmetrise(&result.curvature);
  return result;
}

NdtQuadratic CondensedNdtCost::AutodiffQuadratic(const double* pose, bool with_scatter) const {
  using Jet = ceres::Jet<double, 6>;
  const Eigen::Quaterniond q0 = Eigen::Map<const Eigen::Quaterniond>(pose);
  const Eigen::Matrix3d R0 = q0.toRotationMatrix();
  // (I + [dr]_x) R and t + dt are exact to first order, which is all that Jets carry.
  Eigen::Matrix<Jet, 3, 3> perturbation = Eigen::Matrix3d::Identity().cast<Jet>();
  perturbation(2, 1) += Jet(0.0, 0);
  perturbation(1, 2) -= Jet(0.0, 0);
  perturbation(0, 2) += Jet(0.0, 1);
  perturbation(2, 0) -= Jet(0.0, 1);
  perturbation(1, 0) += Jet(0.0, 2);
  perturbation(0, 1) -= Jet(0.0, 2);
  const Eigen::Matrix<Jet, 3, 3> R = perturbation * R0.cast<Jet>();
  Eigen::Matrix<Jet, 3, 1> t;
  for (int i = 0; i < 3; ++i) t[i] = Jet(pose[4 + i] + origin_[i], 3 + i);

  NdtQuadratic result;
  std::size_t k = 0;
  while (k < pairs_.size()) {
    const int index = pairs_[k].scan;
    const Gaussian3& a = scan_[static_cast<std::size_t>(index)];
    const Eigen::Matrix<Jet, 3, 1> rotated = R * a.mean.cast<Jet>();
    const Eigen::Matrix<Jet, 3, 3> covariance = R * a.covariance.cast<Jet>() * R.transpose();
    Vector6d gradient_of_scan = Vector6d::Zero();
    for (; k < pairs_.size() && pairs_[k].scan == index; ++k) {
      const NdtPairFactor factor(
          a, submap_[static_cast<std::size_t>(pairs_[k].submap)], normalisation_);
      Jet residuals[4];
      factor.Residuals<Jet>(rotated, covariance, t, residuals);
      Eigen::Vector4d r;
      Eigen::Matrix<double, 4, 6> J;
      for (int i = 0; i < 4; ++i) {
        r[i] = residuals[i].a;
        J.row(i) = residuals[i].v.transpose();
      }
      double rho[3];
      NdtPairLoss(a.weight * factor.WellDepth()).Evaluate(r.squaredNorm(), rho);
      result.cost += 0.5 * rho[0];
      const Vector6d half_slope = J.transpose() * r;  // of |r|^2
      gradient_of_scan += rho[1] * half_slope;
      result.hessian += rho[1] * J.transpose() * J;
      if (with_scatter) {
        result.curvature +=
            rho[1] * J.transpose() * J + 2.0 * rho[2] * half_slope * half_slope.transpose();
      }
    }
    result.gradient += gradient_of_scan;
    if (with_scatter) result.scatter += gradient_of_scan * gradient_of_scan.transpose();
  }
  return result;
}

NdtQuadratic CondensedNdtCost::Quadratic(const double* pose, bool with_scatter) const {
  return derivatives_ == NdtDerivatives::kAnalytic ? AnalyticQuadratic(pose, with_scatter)
                                                   : AutodiffQuadratic(pose, with_scatter);
}

bool CondensedNdtCost::Evaluate(double const* const* parameters,
                                double* residuals,
                                double** jacobians) const {
  const double* pose = parameters[0];
  Eigen::Map<Eigen::Matrix<double, 7, 1>> r(residuals);
  if (jacobians == nullptr || jacobians[0] == nullptr) {
    // Without derivatives only |r| matters: a trial step asks for the cost alone.
    r.setZero();
    r[6] = std::sqrt(2.0 * (Cost(pose) + offset_));
    return std::isfinite(r[6]);
  }
  const NdtQuadratic quadratic = Quadratic(pose, /*with_scatter=*/false);
  // A scan may leave directions unobserved: a tiny multiple of the identity keeps H invertible.
  Matrix6d H = quadratic.hessian;
  H.diagonal().array() += 1e-9 * (1.0 + H.diagonal().maxCoeff());
  Eigen::LLT<Matrix6d> llt(H);
  Vector6d head = llt.matrixL().solve(quadratic.gradient);
  const double total = 2.0 * (quadratic.cost + offset_);
  if (head.squaredNorm() > total) {
    // A larger H is a more careful step; the residuals shrink by the root of its factor.
    const double scale = 1.01 * head.squaredNorm() / total;
    H *= scale;
    llt.compute(H);
    head /= std::sqrt(scale);
  }
  r.head<6>() = head;
  r[6] = std::sqrt(std::max(0.0, total - head.squaredNorm()));

  // From the tangent space to the block of seven: a change dq of the quaternion is the rotation
  // vector 2 vec(dq q^-1).
  const Eigen::Map<const Eigen::Quaterniond> q(pose);
  Eigen::Matrix<double, 3, 4> rotation_from_quaternion;
  rotation_from_quaternion << q.w(), -q.z(), q.y(), -q.x(),  //
      q.z(), q.w(), -q.x(), -q.y(),                          //
      -q.y(), q.x(), q.w(), -q.z();
  const Matrix6d J = llt.matrixU();
  Eigen::Map<Eigen::Matrix<double, 7, 7, Eigen::RowMajor>> jacobian(jacobians[0]);
  jacobian.setZero();
  jacobian.topLeftCorner<6, 4>() = 2.0 * J.leftCols<3>() * rotation_from_quaternion;
  jacobian.topRightCorner<6, 3>() = J.rightCols<3>();
  return llt.info() == Eigen::Success && r.allFinite();
}

}  // namespace radive
