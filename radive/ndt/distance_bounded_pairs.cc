// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/distance_bounded_pairs.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace radive {
namespace {

// Edge of the columns that the submap is sorted into [m]. Small against the usual search radius of
// 2 to 5 m, so that little is looked at in vain.
constexpr double kCellSize = 2.0;

std::int64_t CellOf(double coordinate) {
  return static_cast<std::int64_t>(std::floor(coordinate / kCellSize));
}

// Scan Gaussian at the pose of the search.
struct Query {
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
  double max_variance;
};

}  // namespace

std::vector<OptionField> PairOptions::Fields() {
  return {
      {"bound",
       MakeChoice(&bound, {"distance", "none"}),
       "-",
       "distance: only pairs within d_max; none: all pairs (Full NDT)."},
      OptionField{"d_max", &d_max, "m", "Largest distance of a pair's means at the prediction."}
          .Above(0.0),
      {"prune", &prune, "-", "Leave out pairs that cannot contribute near the prediction."},
      OptionField{"max_mahalanobis",
                  &max_mahalanobis,
                  "-",
                  "Squared Mahalanobis distance beyond which a pair is pruned."}
          .Above(0.0),
      OptionField{"slack", &slack, "m", "Error of the prediction that pruning allows for."}.AtLeast(
          0.0),
      OptionField{"max_neighbors",
                  &max_neighbors,
                  "-",
                  "Pairs kept for each scan Gaussian, nearest first; 0 keeps all."}
          .AtLeast(0),
  };
}

double LargestEigenvalue(const Eigen::Matrix3d& m) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(m, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2];
}

PairSearch::PairSearch(const std::vector<Gaussian3>& submap) : submap_(&submap) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
  keyed.reserve(submap.size());
  max_variance_.reserve(submap.size());
  for (std::size_t i = 0; i < submap.size(); ++i) {
    keyed.emplace_back(CellKey(CellOf(submap[i].mean.x()), CellOf(submap[i].mean.y()), 0),
                       static_cast<std::uint32_t>(i));
    max_variance_.push_back(LargestEigenvalue(submap[i].covariance));
    max_variance_of_all_ = std::max(max_variance_of_all_, max_variance_.back());
  }
  std::sort(keyed.begin(), keyed.end());
  order_.reserve(keyed.size());
  for (std::size_t i = 0; i < keyed.size();) {
    Range range{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i)};
    const std::uint64_t key = keyed[i].first;
    for (; i < keyed.size() && keyed[i].first == key; ++i) order_.push_back(keyed[i].second);
    range.end = static_cast<std::uint32_t>(i);
    cells_[key] = range;
  }
}

std::vector<NdtPair> PairSearch::Find(const std::vector<Gaussian3>& scan,
                                      const Rigid3& T_submap_radar,
                                      const PairOptions& options,
                                      double slack) const {
  std::vector<NdtPair> pairs;
  if (submap_->empty()) return pairs;
  if (options.bound == PairOptions::Bound::kNone) {
    pairs.reserve(scan.size() * submap_->size());
    for (std::size_t i = 0; i < scan.size(); ++i) {
      for (std::size_t j = 0; j < submap_->size(); ++j) {
        pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
      }
    }
    return pairs;
  }

  const Eigen::Matrix3d R = T_submap_radar.RotationMatrix();
  std::vector<std::pair<double, int>> candidates;  // (squared Mahalanobis distance, submap index)
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Query query{R * scan[i].mean + T_submap_radar.translation,
                      R * scan[i].covariance * R.transpose(),
                      LargestEigenvalue(scan[i].covariance)};
    double radius = options.d_max;
    if (options.prune) {
      const double reach =
          std::sqrt(options.max_mahalanobis * (query.max_variance + max_variance_of_all_));
      radius = std::min(radius, slack + reach);
    }
    candidates.clear();
    const std::int64_t x_end = CellOf(query.mean.x() + radius);
    const std::int64_t y_end = CellOf(query.mean.y() + radius);
    for (std::int64_t x = CellOf(query.mean.x() - radius); x <= x_end; ++x) {
      for (std::int64_t y = CellOf(query.mean.y() - radius); y <= y_end; ++y) {
        const auto cell = cells_.find(CellKey(x, y, 0));
        if (cell == cells_.end()) continue;
        for (std::uint32_t k = cell->second.begin; k < cell->second.end; ++k) {
          const std::uint32_t j = order_[k];
          const Gaussian3& target = (*submap_)[j];
          const Eigen::Vector3d d = query.mean - target.mean;
          const double squared = d.squaredNorm();
          if (squared > radius * radius) continue;
          if (options.prune) {
            const double excess = std::max(0.0, std::sqrt(squared) - slack);
            if (excess * excess >
                options.max_mahalanobis * (query.max_variance + max_variance_[j])) {
              continue;
            }
          }
          double m = 0.0;
          if (options.max_neighbors > 0) {
            const Eigen::Matrix3d S = query.covariance + target.covariance;
            m = d.dot(S.inverse() * d);
          }
          candidates.emplace_back(m, static_cast<int>(j));
        }
      }
    }
    const std::size_t keep = static_cast<std::size_t>(options.max_neighbors);
    if (keep > 0 && candidates.size() > keep) {
      std::nth_element(candidates.begin(),
                       candidates.begin() + static_cast<std::ptrdiff_t>(keep),
                       candidates.end());
      candidates.resize(keep);
    }
    std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
      return a.second < b.second;
    });
    for (const auto& [m, j] : candidates) pairs.push_back({static_cast<int>(i), j});
  }
  return pairs;
}

}  // namespace radive
