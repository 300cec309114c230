// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/bootstrap.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "radive/util/random.h"

namespace radive {
namespace {

constexpr int kNumDraws = 2000;
constexpr std::uint64_t kSeed = 1;

}  // namespace

double Quantile(std::vector<double> values, double share) {
  CHECK(!values.empty());
  CHECK(share >= 0.0 && share <= 1.0) << share;
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(std::floor(rank));
  std::nth_element(values.begin(), values.begin() + below, values.end());
  const double low = values[static_cast<std::size_t>(below)];
  if (below + 1 == static_cast<std::ptrdiff_t>(values.size())) return low;
  const double high = *std::min_element(values.begin() + below + 1, values.end());
  return low + (rank - static_cast<double>(below)) * (high - low);
}

std::optional<Interval> BootstrapMedian(const std::vector<std::vector<double>>& all_groups,
                                        Draw draw) {
  std::vector<std::vector<double>> groups;
  std::size_t largest = 0;
  for (const std::vector<double>& group : all_groups) {
    if (!group.empty()) groups.push_back(group);
    largest = std::max(largest, group.size());
  }
  if (draw == Draw::kWithinGroups ? largest < 2 : groups.size() < 3) return std::nullopt;
  Random random(kSeed);
  std::vector<double> medians;
  std::vector<double> sample;
  for (int i = 0; i < kNumDraws; ++i) {
    sample.clear();
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::size_t chosen = draw == Draw::kWithinGroups ? g : random.Index(groups.size());
      const std::vector<double>& group = groups[chosen];
      for (std::size_t k = 0; k < group.size(); ++k) {
        sample.push_back(group[random.Index(group.size())]);
      }
    }
    medians.push_back(Quantile(sample, 0.5));
  }
  return Interval{Quantile(medians, 0.025), Quantile(medians, 0.975)};
}

}  // namespace radive
