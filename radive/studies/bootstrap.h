// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

namespace radive {

// The value below which `share` of `values` lie, linear between neighbours (as numpy's default).
// `values` in any order, not empty (checked); 0 <= share <= 1.
double Quantile(std::vector<double> values, double share);

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

// What is drawn again for a bootstrap of values in groups.
enum class Draw {
  kWithinGroups,     // in each group as many values as it has, with replacement
  kGroupsAndWithin,  // as many groups as there are, with replacement; then as above
};

// 95 % interval of the median of all values: the percentiles 2.5 and 97.5 of the medians of 2,000
// samples, drawn with a fixed seed. Nothing when there is too little to draw from: no group of two
// values, or, for groups, fewer than three of them.
std::optional<Interval> BootstrapMedian(const std::vector<std::vector<double>>& groups, Draw draw);

}  // namespace radive
