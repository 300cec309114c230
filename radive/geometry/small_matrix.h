// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

namespace radive {

// Matrices of at most 6x6, a pose's: they are kept on the stack.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;

// Eigenvalues, ascending, and eigenvectors as columns.
struct SmallEigen {
  SmallVector values;
  SmallMatrix vectors;
};

// A v = lambda v for a finite symmetric A, by Jacobi rotations; the vectors are orthonormal.
// Eigen's solvers bring Householder blocks for matrices of any size: ten seconds of compilation in
// each file that uses them.
SmallEigen SymmetricEigen(const SmallMatrix& A);

// A v = lambda B v for a symmetric A and a symmetric positive definite B; V^T B V = I.
SmallEigen GeneralizedEigen(const SmallMatrix& A, const SmallMatrix& B);

// Inverse of a symmetric positive definite matrix.
SmallMatrix InverseOf(const SmallMatrix& B);

}  // namespace radive
