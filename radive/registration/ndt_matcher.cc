// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/registration/ndt_matcher.h"

#include <ceres/problem.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace radive {
namespace {

class NdtMatch : public ScanMatch {
 public:
  NdtMatch(const std::vector<Gaussian3>& scan,
           const std::vector<Gaussian3>& submap,
           std::vector<NdtPair> pairs,
           const Eigen::Vector3d& origin,
           NdtNormalisation normalisation,
           NdtDerivatives derivatives)
      : pairs_(std::move(pairs)), cost_(scan, submap, pairs_, origin, normalisation, derivatives) {}

  void AddTo(ceres::Problem* problem, double* pose) const override {
    // Ceres asks for a mutable pointer and only evaluates.
    problem->AddResidualBlock(const_cast<CondensedNdtCost*>(&cost_), nullptr, pose);
  }
  NdtQuadratic Quadratic(const double* pose) const override { return cost_.Quadratic(pose); }
  double offset() const override { return cost_.offset(); }
  int num_pairs() const override { return static_cast<int>(pairs_.size()); }

  // Pairs are sorted by scan Gaussian.
  int num_scan_gaussians() const override {
    int count = 0;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      if (i == 0 || pairs_[i].scan != pairs_[i - 1].scan) ++count;
    }
    return count;
  }

 private:
  const std::vector<NdtPair> pairs_;
  const CondensedNdtCost cost_;
};

// Full NDT without those pairs that have less than 1e-13 of their weight for every pose which would
// be accepted: the sum is the same to rounding, and the pairs of dense scans fit into memory.
PairOptions AllThatMatter(PairOptions options) {
  options.bound = PairOptions::Bound::kDistance;
  options.d_max = std::numeric_limits<double>::max();
  options.prune = true;
  options.max_mahalanobis = 60.0;
  options.max_neighbors = 0;
  return options;
}

// Pairs stay as long as no Gaussian of the scan moves by more of its own standard deviation.
constexpr double kSameShare = 0.25;

class NdtMatcher : public ScanMatcher {
 public:
  NdtMatcher(const std::vector<Gaussian3>& scan,
             const PairSearch& search,
             const Eigen::Vector3d& origin,
             const PairOptions& pair_options,
             const RegistrationOptions& options)
      : scan_(scan),
        search_(search),
        origin_(origin),
        is_full_(options.method == RegistrationMethod::kFullNdt),
        pair_options_(is_full_ ? AllThatMatter(pair_options) : pair_options),
        options_(options),
        max_variances_(LargestVariances(scan)) {}

  std::unique_ptr<ScanMatch> Associate(const Rigid3& T_submap_radar, double slack) override {
    const double reach = is_full_ ? std::max(slack, options_.max_correction) : slack;
    return std::make_unique<NdtMatch>(
        scan_,
        search_.submap(),
        search_.Find(scan_, max_variances_, T_submap_radar, pair_options_, reach),
        origin_,
        options_.normalisation,
        options_.derivatives);
  }
  bool PairsDiffer(const Rigid3& from, const Rigid3& to) const override {
    const Eigen::Matrix3d turn = to.RotationMatrix() - from.RotationMatrix();
    const Eigen::Vector3d shift = to.translation - from.translation;
    for (std::size_t i = 0; i < scan_.size(); ++i) {
      const double squared_way = (turn * scan_[i].mean + shift).squaredNorm();
      if (squared_way > kSameShare * kSameShare * max_variances_[i]) return true;
    }
    return false;
  }
  bool associates_each_step() const override { return false; }

 private:
  const std::vector<Gaussian3>& scan_;
  const PairSearch& search_;
  const Eigen::Vector3d origin_;
  const bool is_full_;
  const PairOptions pair_options_;
  const RegistrationOptions options_;
  const std::vector<double> max_variances_;  // of the scan's Gaussians
};

}  // namespace

std::unique_ptr<ScanMatcher> MakeNdtMatcher(const std::vector<Gaussian3>& scan,
                                            const PairSearch& search,
                                            const Eigen::Vector3d& origin,
                                            const PairOptions& pair_options,
                                            const RegistrationOptions& options) {
  return std::make_unique<NdtMatcher>(scan, search, origin, pair_options, options);
}

}  // namespace radive
