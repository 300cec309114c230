// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace radive {

// The matrix W with W^T W = covariance^-1: a residual e with that covariance is whitened as W e.
// W is the inverse of the lower Cholesky factor of the covariance. `covariance` must be symmetric
// positive definite.
template <int N>
Eigen::Matrix<double, N, N> SqrtInformation(const Eigen::Matrix<double, N, N>& covariance) {
  const Eigen::LLT<Eigen::Matrix<double, N, N>> llt(covariance);
  return llt.matrixL().solve(Eigen::Matrix<double, N, N>::Identity());
}

}  // namespace radive
