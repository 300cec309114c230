// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/autodiff_cost_function.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace radive {

// Condensed Doppler factor: all returns of a scan in one block.
//
// The DopplerFactors of n returns are linear in v, so their cost is a quadratic form of (v, 1):
//
//   sum_i ((v_doppler_i + d_i^T v) / sigma_i)^2 = (v, 1)^T M (v, 1)
//   M = sum_i a_i a_i^T,  a_i = (d_i, v_doppler_i) / sigma_i
//
// and with M = U^T U four residuals have the same cost, gradient and Gauss-Newton matrix as all n:
//
//   r(v) = U (v, 1)
//
// Symbols, units and frames are those of DopplerFactor. A Doppler that wraps is not linear in v,
// but piece by piece: Sum takes the values nearest to a velocity, and holds within half a span
// around it. A few thousand blocks of one residual cost milliseconds of bookkeeping in Ceres; this
// one costs the sum. Parameter blocks: v (3). Residuals: 4, unit-free. Source: DopplerFactor; the
// tests prove both equal.
class CondensedDopplerFactor {
 public:
  // M. Rounding costs the digits by which the Doppler exceeds the residuals, squared: 1e-11 of the
  // cost at 17 m/s.
  class Sum {
   public:
    Sum() = default;
    explicit Sum(const Eigen::Matrix4d& matrix) : matrix_(matrix) {}

    void Add(const Eigen::Vector3d& direction_radar, double v_doppler, double sigma) {
      Eigen::Vector4d row;
      row << direction_radar, v_doppler;
      row /= sigma;
      matrix_.noalias() += row * row.transpose();
    }
    const Eigen::Matrix4d& matrix() const { return matrix_; }

   private:
    Eigen::Matrix4d matrix_ = Eigen::Matrix4d::Zero();
  };

  explicit CondensedDopplerFactor(const Sum& sum) : root_(Root(sum.matrix())) {}

  template <typename T>
  bool operator()(const T* const v_radar_ptr, T* residuals_ptr) const {
    const Eigen::Map<const Eigen::Matrix<T, 3, 1>> v_radar(v_radar_ptr);
    Eigen::Map<Eigen::Matrix<T, 4, 1>> residuals(residuals_ptr);
    residuals = root_.leftCols<3>().cast<T>() * v_radar + root_.col(3).cast<T>();
    return true;
  }

  static ceres::CostFunction* Create(const Sum& sum) {
    return new ceres::AutoDiffCostFunction<CondensedDopplerFactor,
                                           4 /* residuals */,
                                           3 /* v_radar */>(new CondensedDopplerFactor(sum));
  }

 private:
  // U with U^T U = M. Pivoted, because M is singular for planar sensors and for few returns.
  static Eigen::Matrix4d Root(const Eigen::Matrix4d& matrix) {
    const Eigen::LDLT<Eigen::Matrix4d> ldlt(matrix);
    const Eigen::Matrix4d permutation = ldlt.transpositionsP() * Eigen::Matrix4d::Identity();
    const Eigen::Matrix4d upper = Eigen::Matrix4d(ldlt.matrixU()) * permutation;
    return ldlt.vectorD().cwiseMax(0.0).cwiseSqrt().asDiagonal() * upper;
  }

  const Eigen::Matrix4d root_;
};

}  // namespace radive
