// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/sized_cost_function.h>

#include <Eigen/Core>
#include <vector>

#include "radive/factors/ndt_cost_options.h"
#include "radive/geometry/gaussian3.h"
#include "radive/geometry/rigid3.h"
#include "radive/kernels/ndt_packs.h"
#include "radive/ndt/distance_bounded_pairs.h"

namespace radive {

// Cost, gradient and curvature of the NDT cost of many pairs, in the tangent space
// [rotation vector (3) [rad], translation (3) [m]] of a pose that is perturbed from the left:
// (exp(dr) R, t + dt).
struct NdtQuadratic {
  double cost = 0.0;  // >= 0
  Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();  // PSD approximation

  // For the covariance of the minimum as that of a robust M-estimator,
  // curvature^-1 scatter curvature^-1:
  //
  // The second derivative of the cost with Sigma held fixed. It is smaller than `hessian` by the
  // pull of pairs that are off centre, and may be indefinite.
  Eigen::Matrix<double, 6, 6> curvature = Eigen::Matrix<double, 6, 6>::Zero();
  // Sum over scan Gaussians of g_i g_i^T, their single gradients.
  Eigen::Matrix<double, 6, 6> scatter = Eigen::Matrix<double, 6, 6>::Zero();
};

// All pairs of a scan as one Ceres block.
//
//   C(T) = sum over pairs of w (k_c - k exp(-Delta^T Sigma^-1 Delta / 2))      (NdtPairFactor)
//
// The block hands Ceres seven residuals made from C, its exact gradient g and a positive definite
// matrix H = J^T J:
//
//   r_1..6 = J^-T g,   r_7 = sqrt(2 (C + C0) - |r_1..6|^2),   dr/dT = [J; 0]
//
// so that |r|^2 / 2 = C + C0 and J^T r = g exactly, and Levenberg-Marquardt takes the paper's step
// (H + lambda diag H) dx = -g with the true cost deciding on acceptance. H is the curvature, so
// that steps become Newton's near the minimum, or between it and `hessian` where it is too small in
// some direction. C0 = sum of w k_c is constant; it keeps the root real.
//
// One block a pair costs five times as much in Ceres' bookkeeping alone. The sums are formed by
// kernels (radive/kernels/), four scan Gaussians at a time. The last evaluations are kept: an
// object must not be evaluated by several threads at the same time.
//
// Parameter blocks: T_submap_radar [qx qy qz qw tx ty tz] (7). Residuals: 7.
class CondensedNdtCost : public ceres::SizedCostFunction<7, 7> {
 public:
  // Pairs must be sorted by `scan`. The vectors must outlive the cost function. The means of
  // `submap` are taken relative to `origin`: poses near it then have small translations, in which
  // step tolerances mean what they say.
  CondensedNdtCost(const std::vector<Gaussian3>& scan,
                   const std::vector<Gaussian3>& submap,
                   const std::vector<NdtPair>& pairs,
                   const Eigen::Vector3d& origin,
                   NdtNormalisation normalisation,
                   NdtDerivatives derivatives);

  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override;

  // What the block condenses, at `pose`.
  NdtQuadratic Quadratic(const double* pose) const;

  // The constant C0: final costs are reported without it.
  double offset() const { return offset_; }

 private:
  struct Evaluation {
    PoseBlock pose;
    NdtQuadratic quadratic;
  };

  void MakePacks();
  const NdtQuadratic& At(const double* pose) const;
  NdtQuadratic AutodiffQuadratic(const double* pose) const;
  NdtQuadratic AnalyticQuadratic(const double* pose) const;

  const std::vector<Gaussian3>& scan_;
  const std::vector<Gaussian3>& submap_;
  const std::vector<NdtPair>& pairs_;
  const Eigen::Vector3d origin_;
  const NdtNormalisation normalisation_;
  const NdtDerivatives derivatives_;
  double offset_ = 0.0;

  // The pairs as the kernels take them, for analytic derivatives.
  std::vector<Lanes> scan_packs_, pair_packs_;
  std::vector<int> num_rows_;

  // Levenberg-Marquardt asks for the cost of a trial step and, when it is taken, for the
  // derivatives there; the covariance is asked for at the last step that was taken. The latest
  // first.
  mutable std::vector<Evaluation> evaluations_;
};

}  // namespace radive
