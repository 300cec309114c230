// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/geometry/rigid3.h"
#include "radive/kernels/near_gaussians.h"
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

// Finds pairs against one submap, whose Gaussians may come and go. It must not outlive the submap.
//
// The Gaussians are kept in strips along x, sorted by y within each: what is near in x and y is a
// few runs of neighbours, whose ends are looked up in bins.
class PairSearch {
 public:
  explicit PairSearch(const std::vector<Gaussian3>& submap);

  // After the submap has lost some Gaussians and got others at its end: the work is that of sorting
  // those in. `moved`: where each one before is now, in the same order, or -1: gone. The submap may
  // have moved in memory, not changed otherwise.
  void Update(const std::vector<Gaussian3>& submap, const std::vector<int>& moved);

  // Pairs for the scan at `T_submap_radar`, sorted by scan index, then submap index. `slack` [m]
  // replaces options.slack. `max_variances`: LargestEigenvalue() of the scan's covariances.
  std::vector<NdtPair> Find(const std::vector<Gaussian3>& scan,
                            const std::vector<double>& max_variances,
                            const Rigid3& T_submap_radar,
                            const PairOptions& options,
                            double slack) const;
  std::vector<NdtPair> Find(const std::vector<Gaussian3>& scan,
                            const Rigid3& T_submap_radar,
                            const PairOptions& options,
                            double slack) const;

  const std::vector<Gaussian3>& submap() const { return *submap_; }

 private:
  static constexpr std::size_t kNumFields = 10;  // mean, covariance, largest variance

  struct Rows {
    std::array<std::vector<double>, kNumFields> fields;
    std::vector<int> index;  // in the submap

    void SetRow(std::size_t row, const Gaussian3& gaussian, int index_in_submap);
  };
  struct Strip {
    double number;           // of the strip from the origin, whole
    std::size_t begin, end;  // rows

    // Bins of equal width from the least y to the largest.
    int num_bins = 0;
    double inverse_bin = 0.0;      // [1/m]
    std::size_t first_of_bin = 0;  // in first_rows_
  };
  struct Newcomer {
    double strip, y;
    int index;
  };

  static std::vector<Newcomer> Newcomers(const std::vector<Gaussian3>& submap, std::size_t begin);
  GaussianColumns Columns() const;
  void SortIntoBins();
  int BinOf(const Strip& strip, double y) const;
  // Bounds of the rows of a strip with a y not below, or not above, but for rows of the same bin.
  std::size_t FirstRow(const Strip& strip, double low) const;
  std::size_t EndRow(const Strip& strip, double high) const;
  template <typename Visit>
  void VisitRuns(const Eigen::Vector3d& mean, double radius, const Visit& visit) const;

  const std::vector<Gaussian3>* submap_ = nullptr;
  Rows rows_;   // in the order of strips and y, and some more that are not in use
  Rows spare_;  // to move them to
  std::size_t num_rows_ = 0;
  std::vector<Strip> strips_;
  std::vector<int> first_rows_;  // of the bins of all strips, each strip's end after its last
  double max_variance_ = 0.0;    // of all
};

// LargestEigenvalue() of each covariance [m^2].
std::vector<double> LargestVariances(const std::vector<Gaussian3>& gaussians);

// Largest eigenvalue of a symmetric positive semidefinite matrix.
double LargestEigenvalue(const Eigen::Matrix3d& m);

}  // namespace radive
