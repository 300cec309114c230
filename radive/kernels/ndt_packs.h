// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// Four numbers side by side, one each for four Gaussians or returns.
struct alignas(32) Lanes {
  double value[4] = {0.0, 0.0, 0.0, 0.0};
};

// Pairs of scan and submap Gaussians, four scan Gaussians side by side with one pair of each in a
// row. A Gaussian with fewer pairs than its neighbours has rows of factor 0.
struct NdtPacks {
  static constexpr int kScanFields = 9;   // mean x y z, covariance xx xy xz yy yz zz; radar frame
  static constexpr int kPairFields = 10;  // the same of the submap Gaussian, and the pair's factor

  const Lanes* scan = nullptr;   // num_packs x kScanFields
  const Lanes* pairs = nullptr;  // all rows of the packs x kPairFields
  const int* num_rows = nullptr;
  int num_packs = 0;

  // The height of a pair is its factor, or its factor over the root of the determinant of the
  // covariances together (the paper's).
  bool divides_by_determinant = false;
};

// Sums over pairs of p = height exp(-m / 2) and of its derivatives with respect to the pose
// [rotation vector, translation]; p is what the cost lacks of its constant. The lower triangles of
// symmetric matrices are not filled.
struct NdtSums {
  double height;            // of p
  double gradient[6];       // of the cost
  double hessian[6][6];     // of p Sigma^-1 at the levers of the scan means
  double off_centre[6][6];  // of p q q^T at these levers, q = Sigma^-1 Delta
  double scatter[6][6];     // of the outer products of the scan Gaussians' gradients
};

}  // namespace radive
