// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/distance_bounded_pairs.h"

#include <glog/logging.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "radive/kernels/kernels.h"

namespace radive {
namespace {

// Width of the strips that the submap is sorted into [m]: about half of the usual search radius.
constexpr double kStripWidth = 1.5;

// Mean number of rows of a bin of a strip.
constexpr int kRowsOfBin = 2;

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
  // Planar sensors; what they have off the plane is rounding.
  const double trace = m.trace();
  if (m(0, 2) * m(0, 2) + m(1, 2) * m(1, 2) <= 1e-24 * trace * trace) {
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

PairSearch::PairSearch(const std::vector<Gaussian3>& submap) { Update(submap, {}); }

// Those of the submap from `begin` on, in the order of the rows.
std::vector<PairSearch::Newcomer> PairSearch::Newcomers(const std::vector<Gaussian3>& submap,
                                                        std::size_t begin) {
  std::vector<Newcomer> newcomers;
  newcomers.reserve(submap.size() - begin);
  for (std::size_t i = begin; i < submap.size(); ++i) {
    const Eigen::Vector3d& mean = submap[i].mean;
    newcomers.push_back({StripOf(mean.x()), mean.y(), static_cast<int>(i)});
  }
  std::sort(newcomers.begin(), newcomers.end(), [](const Newcomer& a, const Newcomer& b) {
    if (a.strip != b.strip) return a.strip < b.strip;
    return a.y != b.y ? a.y < b.y : a.index < b.index;
  });
  return newcomers;
}

void PairSearch::Rows::SetRow(std::size_t row, const Gaussian3& gaussian, int index_in_submap) {
  const Eigen::Matrix3d& S = gaussian.covariance;
  const double values[kNumFields] = {gaussian.mean.x(),
                                     gaussian.mean.y(),
                                     gaussian.mean.z(),
                                     S(0, 0),
                                     S(0, 1),
                                     S(0, 2),
                                     S(1, 1),
                                     S(1, 2),
                                     S(2, 2),
                                     LargestEigenvalue(S)};
  for (std::size_t i = 0; i < kNumFields; ++i) fields[i][row] = values[i];
  index[row] = index_in_submap;
}

void PairSearch::Update(const std::vector<Gaussian3>& submap, const std::vector<int>& moved) {
  CHECK_EQ(moved.size(), num_rows_);
  const auto num_left =
      std::count_if(moved.begin(), moved.end(), [](int index) { return index >= 0; });
  const std::vector<Newcomer> newcomers = Newcomers(submap, static_cast<std::size_t>(num_left));

  // Where the rows of those that stay go, in runs, and those of the newcomers.
  struct Run {
    std::size_t from, to, size;
  };
  std::vector<Run> runs;
  std::vector<std::size_t> new_rows;
  std::vector<Strip> strips;
  std::size_t to = 0;
  const auto take_old = [&](std::size_t begin, std::size_t end) {
    if (begin == end) return;
    runs.push_back({begin, to, end - begin});
    to += end - begin;
  };
  const auto next = [&]() {
    return newcomers.begin() + static_cast<std::ptrdiff_t>(new_rows.size());
  };
  const auto take_strips_before = [&](double number) {
    while (next() != newcomers.end() && next()->strip < number) {
      if (strips.empty() || strips.back().number != next()->strip) {
        strips.push_back({next()->strip, to, to});
      }
      new_rows.push_back(to++);
      strips.back().end = to;
    }
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Strip& strip : strips_) {
    take_strips_before(strip.number);
    const std::size_t first = to;
    const auto next_y = [&] {
      return next() != newcomers.end() && next()->strip == strip.number ? next()->y : kInfinity;
    };
    double newcomer_y = next_y();
    std::size_t begin = strip.begin;
    for (std::size_t row = strip.begin; row < strip.end; ++row) {
      const bool is_gone = moved[static_cast<std::size_t>(rows_.index[row])] < 0;
      const double y = rows_.fields[1][row];
      if (!is_gone && y <= newcomer_y) continue;
      take_old(begin, row);
      begin = is_gone ? row + 1 : row;
      for (; newcomer_y < y; newcomer_y = next_y()) new_rows.push_back(to++);
    }
    take_old(begin, strip.end);
    for (; newcomer_y < kInfinity; newcomer_y = next_y()) new_rows.push_back(to++);
    if (to > first) strips.push_back({strip.number, first, to});
  }
  take_strips_before(kInfinity);

  const auto move_runs = [&](auto& column, auto& spare) {
    if (spare.size() < to + kNumSpareRows) spare.resize(to + to / 4 + kNumSpareRows);
    for (const Run& run : runs) {
      std::copy_n(column.begin() + static_cast<std::ptrdiff_t>(run.from),
                  run.size,
                  spare.begin() + static_cast<std::ptrdiff_t>(run.to));
    }
  };
  for (std::size_t i = 0; i < kNumFields; ++i) move_runs(rows_.fields[i], spare_.fields[i]);
  move_runs(rows_.index, spare_.index);
  std::swap(rows_, spare_);
  for (const Run& run : runs) {
    for (std::size_t row = run.to; row < run.to + run.size; ++row) {
      rows_.index[row] = moved[static_cast<std::size_t>(rows_.index[row])];
    }
  }
  for (std::size_t i = 0; i < newcomers.size(); ++i) {
    const int index = newcomers[i].index;
    rows_.SetRow(new_rows[i], submap[static_cast<std::size_t>(index)], index);
  }
  submap_ = &submap;
  num_rows_ = to;
  strips_ = std::move(strips);
  max_variance_ = 0.0;
  for (std::size_t row = 0; row < num_rows_; ++row) {
    max_variance_ = std::max(max_variance_, rows_.fields[9][row]);
  }
  SortIntoBins();
}

void PairSearch::SortIntoBins() {
  const double* y = rows_.fields[1].data();
  first_rows_.clear();
  for (Strip& strip : strips_) {
    strip.first_of_bin = first_rows_.size();
    strip.num_bins = static_cast<int>(strip.end - strip.begin + kRowsOfBin - 1) / kRowsOfBin;
    const double width = y[strip.end - 1] - y[strip.begin];
    strip.inverse_bin = width > 0.0 ? strip.num_bins / width : 0.0;
    int next_bin = 0;
    for (std::size_t row = strip.begin; row < strip.end; ++row) {
      const int bin = BinOf(strip, y[row]);
      for (; next_bin <= bin; ++next_bin) first_rows_.push_back(static_cast<int>(row));
    }
    first_rows_.push_back(static_cast<int>(strip.end));
  }
}

// Grows with y.
inline int PairSearch::BinOf(const Strip& strip, double y) const {
  const double bin = (y - rows_.fields[1][strip.begin]) * strip.inverse_bin;
  const double last = strip.num_bins - 1;
  return static_cast<int>(bin < last ? std::max(0.0, bin) : last);
}

std::size_t PairSearch::FirstRow(const Strip& strip, double low) const {
  if (low > rows_.fields[1][strip.end - 1]) return strip.end;
  return static_cast<std::size_t>(
      first_rows_[strip.first_of_bin + static_cast<std::size_t>(BinOf(strip, low))]);
}

std::size_t PairSearch::EndRow(const Strip& strip, double high) const {
  if (high < rows_.fields[1][strip.begin]) return strip.begin;
  return static_cast<std::size_t>(
      first_rows_[strip.first_of_bin + static_cast<std::size_t>(BinOf(strip, high)) + 1]);
}

GaussianColumns PairSearch::Columns() const {
  GaussianColumns columns;
  for (std::size_t i = 0; i < 3; ++i) columns.mean[i] = rows_.fields[i].data();
  for (std::size_t i = 0; i < 6; ++i) columns.covariance[i] = rows_.fields[3 + i].data();
  columns.max_variance = rows_.fields[9].data();
  columns.index = rows_.index.data();
  return columns;
}

// Calls visit(begin, end) for runs of rows that hold all within a radius of `mean` in x and y, the
// nearest strips first. visit() returns the radius for what is left.
template <typename Visit>
void PairSearch::VisitRuns(const Eigen::Vector3d& mean, double radius, const Visit& visit) const {
  const auto visit_rows = [&](std::size_t begin, std::size_t end) {
    if (begin < end) radius = visit(static_cast<int>(begin), static_cast<int>(end));
  };
  auto right = std::lower_bound(
      strips_.begin(), strips_.end(), StripOf(mean.x()), [](const Strip& strip, double number) {
        return strip.number < number;
      });
  auto left = right;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  while (true) {
    const double to_right =
        right == strips_.end() ? kInfinity : right->number * kStripWidth - mean.x();
    const double to_left = left == strips_.begin()
                               ? kInfinity
                               : mean.x() - (std::prev(left)->number + 1.0) * kStripWidth;
    const double distance = std::max(0.0, std::min(to_right, to_left));
    if (!(distance <= radius)) return;
    const Strip& strip = to_right <= to_left ? *right++ : *--left;
    if (distance == 0.0 && radius > kStripWidth) {  // what is near may narrow the rest down
      const double core = 0.5 * kStripWidth;
      const std::size_t begin = FirstRow(strip, mean.y() - core);
      const std::size_t end = std::max(begin, EndRow(strip, mean.y() + core));
      visit_rows(begin, end);
      visit_rows(FirstRow(strip, mean.y() - radius), begin);
      visit_rows(end, EndRow(strip, mean.y() + radius));
      continue;
    }
    const double half = std::sqrt(radius * radius - distance * distance);
    visit_rows(FirstRow(strip, mean.y() - half), EndRow(strip, mean.y() + half));
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
    const double largest_variances = max_variances[i] + max_variance_;
    VisitRuns(mean, query.max_distance, [&](int begin, int end) {
      kernels.find_near(columns, begin, end, query, &found);
      if (found.count != options.max_neighbors || found.count == 0) return query.max_distance;
      // Whatever is further away than this cannot be nearer by Mahalanobis distance.
      constexpr double kRounding = 1.0 + 1e-9;
      const double most = found.mahalanobis[found.furthest];
      return std::min(query.max_distance, kRounding * std::sqrt(most * largest_variances));
    });
    std::sort(indices.begin(), indices.begin() + found.count);
    for (int k = 0; k < found.count; ++k) {
      pairs.push_back({static_cast<int>(i), indices[static_cast<std::size_t>(k)]});
    }
  }
  return pairs;
}

}  // namespace radive
