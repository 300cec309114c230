// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>
#include <ceres/loss_function.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "radive/factors/ndt_cost_options.h"
#include "radive/geometry/gaussian3.h"

namespace radive {

// NDT pair factor: a Gaussian of the scan against a Gaussian of the submap.
//
//   Delta = R mu_A + t - mu_B,   Sigma = R Sigma_A R^T + Sigma_B = L L^T
//   r     = [ L^-1 Delta ; sqrt(log(|Sigma| / c)) ]
//
// With Loss() this is the paper's cost w (1 - k exp(-Delta^T Sigma^-1 Delta / 2)), with
// k = ((2 pi)^3 |Sigma|)^-1/2, up to a constant:  rho(|r|^2) / 2 = w (k_c - k exp(...)). The last
// residual carries the change of k with the rotation; kUnit sets k = 1 and holds it at zero.
//
// T_submap_radar = (R, t)  pose of the radar in the submap: maps mu_A to the submap frame
// mu_A, Sigma_A            Gaussian of the scan, radar frame      [m, m^2]
// mu_B, Sigma_B            Gaussian of the submap, submap frame   [m, m^2]
// w                        velocity-discrepancy weight of A       [-]
// c                        half of (|Sigma_A|^(1/3) + |Sigma_B|^(1/3))^3, which Minkowski's
//                          determinant inequality puts below |Sigma| for all R; the half keeps
//                          the logarithm above log 2, where its root can be differentiated
//
// Parameter blocks: T_submap_radar [qx qy qz qw tx ty tz] (7). Residuals: 4, unit-free.
// Source: RaDiVe, Eq. of the weighted NDT cost ("Cost Function").
class NdtPairFactor {
 public:
  NdtPairFactor(const Gaussian3& scan, const Gaussian3& submap, NdtNormalisation normalisation)
      : mean_a_(scan.mean),
        covariance_a_(scan.covariance),
        mean_b_(submap.mean),
        covariance_b_(submap.covariance),
        normalisation_(normalisation),
        c_(DeterminantBound(scan.covariance, submap.covariance)) {}

  template <typename T>
  bool operator()(const T* const pose, T* residuals) const {
    const Eigen::Map<const Eigen::Quaternion<T>> q(pose);
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> t(pose + 4);
    const Eigen::Matrix<T, 3, 3> R = q.toRotationMatrix();
    const Eigen::Matrix<T, 3, 1> rotated = R * mean_a_.cast<T>();
    const Eigen::Matrix<T, 3, 3> S = R * covariance_a_.cast<T>() * R.transpose();
    Residuals<T>(rotated, S, t, residuals);
    return true;
  }

  // The same from R mu_A and R Sigma_A R^T, which all pairs of one scan Gaussian share.
  template <typename T, typename Translation>
  void Residuals(const Eigen::Matrix<T, 3, 1>& rotated_mean,
                 const Eigen::Matrix<T, 3, 3>& rotated_covariance,
                 const Translation& t,
                 T* residuals) const {
    using std::log;
    using std::sqrt;
    const Eigen::Matrix<T, 3, 1> d = rotated_mean + t - mean_b_.cast<T>();
    const Eigen::Matrix<T, 3, 3> S = rotated_covariance + covariance_b_.cast<T>();
    // Cholesky factor and forward substitution, written out so that Jets pass.
    const T l00 = sqrt(S(0, 0));
    const T l10 = S(1, 0) / l00;
    const T l20 = S(2, 0) / l00;
    const T l11 = sqrt(S(1, 1) - l10 * l10);
    const T l21 = (S(2, 1) - l20 * l10) / l11;
    const T l22 = sqrt(S(2, 2) - l20 * l20 - l21 * l21);
    residuals[0] = d[0] / l00;
    residuals[1] = (d[1] - l10 * residuals[0]) / l11;
    residuals[2] = (d[2] - l20 * residuals[0] - l21 * residuals[1]) / l22;
    residuals[3] = T(0.0);
    if (normalisation_ == NdtNormalisation::kPaper) {
      const T root = l00 * l11 * l22;
      residuals[3] = sqrt(log(root * root / c_));
    }
  }

  // Height of the cost's well at zero residuals: k_c of the comment above (1 for kUnit). The loss
  // is that of Loss(weight, WellDepth()).
  double WellDepth() const {
    constexpr double kTwoPiCubed = 248.05021344239853;
    return normalisation_ == NdtNormalisation::kUnit ? 1.0 : 1.0 / std::sqrt(kTwoPiCubed * c_);
  }

  static ceres::CostFunction* Create(const Gaussian3& scan,
                                     const Gaussian3& submap,
                                     NdtNormalisation normalisation) {
    return new ceres::AutoDiffCostFunction<NdtPairFactor, 4 /* residuals */, 7 /* pose */>(
        new NdtPairFactor(scan, submap, normalisation));
  }

  static double DeterminantBound(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
    const double root = std::cbrt(a.determinant()) + std::cbrt(b.determinant());
    return 0.5 * root * root * root;
  }

 private:
  const Eigen::Vector3d mean_a_;
  const Eigen::Matrix3d covariance_a_;
  const Eigen::Vector3d mean_b_;
  const Eigen::Matrix3d covariance_b_;
  const NdtNormalisation normalisation_;
  const double c_;
};

// Loss of the NDT pair factor: rho(s) = 2 depth (1 - exp(-s / 2)), with depth = w k_c. A Welsch
// loss in standard deviations.
class NdtPairLoss : public ceres::LossFunction {
 public:
  explicit NdtPairLoss(double depth) : depth_(depth) {}

  void Evaluate(double s, double rho[3]) const override {
    const double e = std::exp(-0.5 * s);
    rho[0] = 2.0 * depth_ * (1.0 - e);
    rho[1] = depth_ * e;
    rho[2] = -0.5 * depth_ * e;
  }

 private:
  const double depth_;
};

}  // namespace radive
