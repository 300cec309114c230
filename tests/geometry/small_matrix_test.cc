// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/geometry/small_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace radive {
namespace {

// A symmetric 6x6 with the scales of a pose's information: rotations 1e6, translations 1.
SmallMatrix PoseInformation() {
  SmallMatrix J(6, 6);
  J << 900, 10, -30, 0.1, 0.2, 0.1,  //
      20, 700, 50, -0.3, 0.4, 0.5,   //
      -10, 40, 800, 0.2, -0.1, 0.3,  //
      1, 2, -1, 0.9, 0.1, 0.0,       //
      3, -2, 1, 0.2, 1.1, -0.2,      //
      0, 1, 2, -0.1, 0.3, 0.7;
  return J.transpose() * J;
}

TEST(SmallMatrix, EigenvaluesOfTwoByTwo) {
  SmallMatrix A(2, 2);
  A << 2.0, 1.0, 1.0, 2.0;  // (1, -1) / sqrt(2): 1; (1, 1) / sqrt(2): 3
  const SmallEigen eigen = SymmetricEigen(A);
  EXPECT_NEAR(eigen.values[0], 1.0, 1e-15);
  EXPECT_NEAR(eigen.values[1], 3.0, 1e-15);
  EXPECT_NEAR(eigen.vectors(0, 0), -eigen.vectors(1, 0), 1e-15);
  EXPECT_NEAR(eigen.vectors(0, 1), eigen.vectors(1, 1), 1e-15);
}

TEST(SmallMatrix, IndefiniteIsSortedFromTheMostNegative) {
  SmallMatrix A(3, 3);
  A << 0.0, 2.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 1.0;  // -2, 1, 2
  const SmallEigen eigen = SymmetricEigen(A);
  EXPECT_NEAR(eigen.values[0], -2.0, 1e-15);
  EXPECT_NEAR(eigen.values[1], 1.0, 1e-15);
  EXPECT_NEAR(eigen.values[2], 2.0, 1e-15);
}

TEST(SmallMatrix, VectorsDiagonaliseAPosesInformation) {
  const SmallMatrix A = PoseInformation();
  const SmallEigen eigen = SymmetricEigen(A);
  const SmallMatrix again = eigen.vectors * eigen.values.asDiagonal() * eigen.vectors.transpose();
  EXPECT_LT((again - A).norm(), 1e-14 * A.norm());
  const SmallMatrix unit = eigen.vectors.transpose() * eigen.vectors;
  EXPECT_LT((unit - SmallMatrix::Identity(6, 6)).norm(), 1e-14);
}

TEST(SmallMatrix, GeneralizedEigenvectorsWhitenB) {
  const SmallMatrix B = PoseInformation();
  SmallMatrix A = 0.3 * B;
  A(5, 5) -= 2.0;
  const SmallEigen eigen = GeneralizedEigen(A, B);
  const SmallMatrix unit = eigen.vectors.transpose() * B * eigen.vectors;
  EXPECT_LT((unit - SmallMatrix::Identity(6, 6)).norm(), 1e-12);
  const SmallMatrix lhs = A * eigen.vectors;
  const SmallMatrix rhs = B * eigen.vectors * eigen.values.asDiagonal();
  EXPECT_LT((lhs - rhs).norm(), 1e-12 * lhs.norm());
  // A change of rank one moves one eigenvalue: five stay 0.3.
  EXPECT_LT(eigen.values[0], 0.0);
  for (int i = 1; i < 6; ++i) EXPECT_NEAR(eigen.values[i], 0.3, 1e-12);
}

TEST(SmallMatrix, InverseOfAPosesInformation) {
  const SmallMatrix B = PoseInformation();
  EXPECT_LT((InverseOf(B) * B - SmallMatrix::Identity(6, 6)).norm(), 1e-9);
}

}  // namespace
}  // namespace radive
