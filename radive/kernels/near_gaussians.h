// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// Gaussians of a submap, a column for each number of theirs. Three more rows than are in use must
// be there to be read.
struct GaussianColumns {
  const double* mean[3];        // x y z [m]
  const double* covariance[6];  // xx xy xz yy yz zz [m^2]
  const double* max_variance;   // largest eigenvalue of the covariance [m^2]
  const int* index;             // in the submap
};

// A scan Gaussian in the submap frame, and what makes a submap Gaussian a pair of it: a distance of
// the means of at most max_distance, and max(0, distance - slack)^2 of at most max_mahalanobis
// times the largest variances together.
struct NearQuery {
  double mean[3];
  double covariance[6];
  double max_variance;
  double max_distance;
  double slack;
  double max_mahalanobis;  // infinite: no such bound
  int num_kept;  // those of smallest Mahalanobis distance, of equal ones the first; 0: all
};

// What has been found so far. `num_kept` places, or, where all are kept, as many more as rows are
// looked at.
struct NearFound {
  double* mahalanobis;  // squared; not filled where all are kept
  int* index;
  int count = 0;
  int furthest = 0;  // place of the one that goes first, once num_kept are found
};

}  // namespace radive
