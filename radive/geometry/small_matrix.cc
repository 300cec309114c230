// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/geometry/small_matrix.h"

#include <Eigen/Cholesky>
#include <Eigen/Jacobi>
#include <cmath>
#include <limits>
#include <utility>

namespace radive {
namespace {

// Each sweep about squares what is left off the diagonal; six are plenty for 6x6.
constexpr int kMaxSweeps = 30;

// L^-1 of B = L L^T.
SmallMatrix InverseFactor(const SmallMatrix& B) {
  return Eigen::LLT<SmallMatrix>(B).matrixL().solve(SmallMatrix::Identity(B.rows(), B.cols()));
}

}  // namespace

SmallEigen SymmetricEigen(const SmallMatrix& A) {
  const Eigen::Index n = A.rows();
  SmallMatrix D = A;
  SmallEigen eigen;
  eigen.vectors = SmallMatrix::Identity(n, n);
  bool has_turned = true;
  for (int sweep = 0; has_turned && sweep < kMaxSweeps; ++sweep) {
    has_turned = false;
    for (Eigen::Index p = 0; p < n; ++p) {
      for (Eigen::Index q = p + 1; q < n; ++q) {
        // As small as rounding of the two diagonal elements: nothing to gain.
        const double smallest = std::numeric_limits<double>::epsilon() *
                                std::sqrt(std::abs(D(p, p)) * std::abs(D(q, q)));
        Eigen::JacobiRotation<double> rotation;
        if (!(std::abs(D(p, q)) > smallest) || !rotation.makeJacobi(D, p, q)) continue;
        D.applyOnTheLeft(p, q, rotation.adjoint());
        D.applyOnTheRight(p, q, rotation);
        D(p, q) = D(q, p) = 0.0;
        eigen.vectors.applyOnTheRight(p, q, rotation);
        has_turned = true;
      }
    }
  }
  eigen.values = D.diagonal();
  for (Eigen::Index i = 0; i + 1 < n; ++i) {
    Eigen::Index least = 0;
    eigen.values.tail(n - i).minCoeff(&least);
    if (least == 0) continue;
    std::swap(eigen.values[i], eigen.values[i + least]);
    eigen.vectors.col(i).swap(eigen.vectors.col(i + least));
  }
  return eigen;
}

SmallEigen GeneralizedEigen(const SmallMatrix& A, const SmallMatrix& B) {
  const SmallMatrix W = InverseFactor(B);
  const SmallMatrix whitened = W * A * W.transpose();
  SmallEigen eigen = SymmetricEigen(0.5 * (whitened + whitened.transpose()));
  eigen.vectors = (W.transpose() * eigen.vectors).eval();
  return eigen;
}

SmallMatrix InverseOf(const SmallMatrix& B) {
  const SmallMatrix W = InverseFactor(B);
  return W.transpose() * W;
}

}  // namespace radive
