// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/distance_bounded_pairs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "radive/kernels/kernels.h"

namespace radive {
namespace {

// Width of the strips that the submap is sorted into [m]: about half of the usual search radius.
constexpr double kStripWidth = 1.5;

// Rows that are read beyond the last one.
constexpr std::size_t kNumSpareRows = 3;

double StripOf(double x) { return std::floor(x / kStripWidth); }

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
  if (m(0, 2) == 0.0 && m(1, 2) == 0.0) {  // planar sensors
    const double half_difference = 0.5 * (m(0, 0) - m(1, 1));
    const double root = std::sqrt(half_difference * half_difference + m(0, 1) * m(0, 1));
    return std::max(m(2, 2), 0.5 * (m(0, 0) + m(1, 1)) + root);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(m, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[2];
}

std::vector<double> LargestVariances(const std::vector<Gaussian3>& gaussians) {
  std::vector<double> variances;
  variances.reserve(gaussians.size());
  for (const Gaussian3& gaussian : gaussians) {
    variances.push_back(LargestEigenvalue(gaussian.covariance));
  }
  return variances;
}

PairSearch::PairSearch(const std::vector<Gaussian3>& submap) { Update(submap, 0); }

// Those of the submap from `begin` on, in the order of the rows.
std::vector<PairSearch::Newcomer> PairSearch::Newcomers(std::size_t begin) const {
  std::vector<Newcomer> newcomers;
  newcomers.reserve(submap_->size() - begin);
  for (std::size_t i = begin; i < submap_->size(); ++i) {
    const Eigen::Vector3d& mean = (*submap_)[i].mean;
    newcomers.push_back({StripOf(mean.x()), mean.y(), static_cast<int>(i)});
  }
  std::sort(newcomers.begin(), newcomers.end(), [](const Newcomer& a, const Newcomer& b) {
    if (a.strip != b.strip) return a.strip < b.strip;
    return a.y != b.y ? a.y < b.y : a.index < b.index;
  });
  return newcomers;
}

void PairSearch::AppendRow(int index) {
  const Gaussian3& gaussian = (*submap_)[static_cast<std::size_t>(index)];
  const Eigen::Matrix3d& S = gaussian.covariance;
  const double row[kNumFields] = {gaussian.mean.x(),
                                  gaussian.mean.y(),
                                  gaussian.mean.z(),
                                  S(0, 0),
                                  S(0, 1),
                                  S(0, 2),
                                  S(1, 1),
                                  S(1, 2),
                                  S(2, 2),
                                  LargestEigenvalue(S)};
  for (std::size_t i = 0; i < kNumFields; ++i) fields_[i].push_back(row[i]);
  index_.push_back(index);
}

void PairSearch::Update(const std::vector<Gaussian3>& submap, std::size_t num_gone) {
  submap_ = &submap;
  const std::size_t num_old = index_.size() - (index_.empty() ? 0 : kNumSpareRows);
  const std::vector<Newcomer> newcomers = Newcomers(num_old - num_gone);
  // The newcomers' rows go behind the old ones; then all are copied in their order, run by run.
  for (std::vector<double>& field : fields_) field.resize(num_old);
  index_.resize(num_old);
  for (int& index : index_) index -= static_cast<int>(num_gone);
  for (const Newcomer& newcomer : newcomers) AppendRow(newcomer.index);

  struct Run {
    std::size_t begin, end;
  };
  std::vector<Run> runs;
  std::vector<Strip> strips;
  int num_rows = 0;
  const auto append = [&](double strip, std::size_t row) {
    if (runs.empty() || runs.back().end != row) runs.push_back({row, row});
    ++runs.back().end;
    if (strips.empty() || strips.back().number != strip) {
      strips.push_back({strip, num_rows, num_rows});
    }
    strips.back().end = ++num_rows;
  };
  std::size_t next = 0;
  const auto append_newcomers_before = [&](double strip, double y) {
    for (; next < newcomers.size(); ++next) {
      const Newcomer& newcomer = newcomers[next];
      if (newcomer.strip > strip || (newcomer.strip == strip && newcomer.y >= y)) return;
      append(newcomer.strip, num_old + next);
    }
  };
  for (const Strip& strip : strips_) {
    for (auto row = static_cast<std::size_t>(strip.begin);
         row < static_cast<std::size_t>(strip.end);
         ++row) {
      if (index_[row] < 0) continue;
      append_newcomers_before(strip.number, fields_[1][row]);
      append(strip.number, row);
    }
  }
  constexpr double kEnd = std::numeric_limits<double>::infinity();
  append_newcomers_before(kEnd, kEnd);

  const auto reorder = [&](auto* column) {
    std::remove_reference_t<decltype(*column)> ordered;
    ordered.reserve(submap.size() + kNumSpareRows);
    for (const Run& run : runs) {
      ordered.insert(ordered.end(),
                     column->begin() + static_cast<std::ptrdiff_t>(run.begin),
                     column->begin() + static_cast<std::ptrdiff_t>(run.end));
    }
    ordered.resize(ordered.size() + kNumSpareRows);
    *column = std::move(ordered);
  };
  for (std::vector<double>& field : fields_) reorder(&field);
  reorder(&index_);
  strips_ = std::move(strips);
  max_variance_ = *std::max_element(fields_.back().begin(), fields_.back().end());
}

GaussianColumns PairSearch::Columns() const {
  GaussianColumns columns;
  for (std::size_t i = 0; i < 3; ++i) columns.mean[i] = fields_[i].data();
  for (std::size_t i = 0; i < 6; ++i) columns.covariance[i] = fields_[3 + i].data();
  columns.max_variance = fields_[9].data();
  columns.index = index_.data();
  return columns;
}

// Calls visit(begin, end) for runs of rows that hold all within `radius` of `mean` in x and y.
template <typename Visit>
void PairSearch::VisitRuns(const Eigen::Vector3d& mean, double radius, const Visit& visit) const {
  const double last = StripOf(mean.x() + radius);
  auto strip = std::lower_bound(
      strips_.begin(),
      strips_.end(),
      StripOf(mean.x() - radius),
      [](const Strip& candidate, double number) { return candidate.number < number; });
  const double* y = fields_[1].data();
  for (; strip != strips_.end() && strip->number <= last; ++strip) {
    const double* begin = std::lower_bound(y + strip->begin, y + strip->end, mean.y() - radius);
    const double* end = std::upper_bound(begin, y + strip->end, mean.y() + radius);
    if (begin != end) visit(static_cast<int>(begin - y), static_cast<int>(end - y));
  }
}

std::vector<NdtPair> PairSearch::Find(const std::vector<Gaussian3>& scan,
                                      const Rigid3& T_submap_radar,
                                      const PairOptions& options,
                                      double slack) const {
  return Find(scan, LargestVariances(scan), T_submap_radar, options, slack);
}

std::vector<NdtPair> PairSearch::Find(const std::vector<Gaussian3>& scan,
                                      const std::vector<double>& max_variances,
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

  const Kernels& kernels = ActiveKernels();
  const GaussianColumns columns = Columns();
  const Eigen::Matrix3d R = T_submap_radar.RotationMatrix();
  const auto num_kept = static_cast<std::size_t>(options.max_neighbors);
  std::vector<double> mahalanobis(num_kept);
  std::vector<int> indices(num_kept == 0 ? submap_->size() : num_kept);
  pairs.reserve(scan.size() * num_kept);
  for (std::size_t i = 0; i < scan.size(); ++i) {
    const Eigen::Vector3d mean = R * scan[i].mean + T_submap_radar.translation;
    const Eigen::Matrix3d S = R * scan[i].covariance * R.transpose();
    NearQuery query = {{mean.x(), mean.y(), mean.z()},
                       {S(0, 0), S(0, 1), S(0, 2), S(1, 1), S(1, 2), S(2, 2)},
                       max_variances[i],
                       options.d_max,
                       slack,
                       std::numeric_limits<double>::infinity(),
                       options.max_neighbors};
    if (options.prune) {
      query.max_mahalanobis = options.max_mahalanobis;
      const double reach = std::sqrt(options.max_mahalanobis * (max_variances[i] + max_variance_));
      query.max_distance = std::min(query.max_distance, slack + reach);
    }
    NearFound found = {mahalanobis.data(), indices.data()};
    VisitRuns(mean, query.max_distance, [&](int begin, int end) {
      kernels.find_near(columns, begin, end, query, &found);
    });
    std::sort(indices.begin(), indices.begin() + found.count);
    for (int k = 0; k < found.count; ++k) {
      pairs.push_back({static_cast<int>(i), indices[static_cast<std::size_t>(k)]});
    }
  }
  return pairs;
}

}  // namespace radive
