// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace radive {

// Index in [begin, values.size()) of the value nearest to `target`, the first of them on ties.
// `values` ascends (equal neighbours allowed); the range must not be empty. The distance is the
// double |value - target|, so that ties and limits fall as in a plain scan over all values.
inline std::size_t NearestAscending(const std::vector<double>& values,
                                    std::size_t begin,
                                    double target) {
  const auto distance = [&](std::size_t i) { return std::abs(values[i] - target); };
  const auto first = values.begin() + static_cast<std::ptrdiff_t>(begin);
  std::size_t best =
      static_cast<std::size_t>(std::lower_bound(first, values.end(), target) - values.begin());
  if (best == values.size()) --best;
  while (best > begin && distance(best - 1) <= distance(best)) --best;
  return best;
}

}  // namespace radive
