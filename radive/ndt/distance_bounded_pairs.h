// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tsl/robin_map.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/geometry/rigid3.h"
#include "radive/util/cell_key.h"
#include "radive/util/option_field.h"

namespace radive {

// One correspondence: indices into the scan's and the submap's Gaussians.
struct NdtPair {
  int scan = 0;
  int submap = 0;
};

// Which pairs of scan and submap Gaussians enter the cost.
struct PairOptions {
  enum class Bound {
    kDistance,  // only pairs within d_max (the paper's distance-bounded NDT)
    kNone,      // all pairs (Full NDT of the paper's ablation)
  };
  Bound bound = Bound::kDistance;

  double d_max = 5.0;  // between the means at the prediction [m]

  // Pairs that contribute next to nothing for any pose within `slack` of the prediction are left
  // out: those with max(0, distance - slack)^2 > max_mahalanobis * (largest variances together).
  bool prune = true;
  double max_mahalanobis = 9.0;  // squared [-]
  double slack = 0.5;            // [m]

  // Pairs kept for each scan Gaussian, those of smallest Mahalanobis distance; 0: all.
  int max_neighbors = 10;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("pairs", *this, error); }
};

// Finds pairs against one submap. Building it is linear in the submap; it must not outlive it.
class PairSearch {
 public:
  explicit PairSearch(const std::vector<Gaussian3>& submap);

  // Pairs for the scan at `T_submap_radar`, sorted by scan index, then submap index. `slack` [m]
  // replaces options.slack.
  std::vector<NdtPair> Find(const std::vector<Gaussian3>& scan,
                            const Rigid3& T_submap_radar,
                            const PairOptions& options,
                            double slack) const;

  const std::vector<Gaussian3>& submap() const { return *submap_; }

 private:
  struct Range {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  const std::vector<Gaussian3>* submap_;
  std::vector<double> max_variance_;  // largest eigenvalue of each covariance [m^2]
  double max_variance_of_all_ = 0.0;
  std::vector<std::uint32_t> order_;  // submap indices, cell by cell, ascending within a cell
  tsl::robin_map<std::uint64_t, Range, CellKeyHash> cells_;  // columns of kCellSize x kCellSize
};

// Largest eigenvalue of a symmetric positive semidefinite matrix.
double LargestEigenvalue(const Eigen::Matrix3d& m);

}  // namespace radive
