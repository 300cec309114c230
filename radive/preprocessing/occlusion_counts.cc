// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/preprocessing/occlusion_counts.h"

#include <glog/logging.h>

#include <algorithm>
#include <numeric>

namespace radive {

std::vector<int> OcclusionCounts(const std::vector<double>& azimuths,
                                 const std::vector<double>& ranges,
                                 const std::vector<bool>& can_hide,
                                 const OcclusionOptions& options) {
  CHECK_EQ(azimuths.size(), ranges.size());
  CHECK_EQ(azimuths.size(), can_hide.size());
  std::vector<std::size_t> hiding;
  for (std::size_t i = 0; i < azimuths.size(); ++i) {
    if (can_hide[i]) hiding.push_back(i);
  }
  std::sort(hiding.begin(), hiding.end(), [&](std::size_t a, std::size_t b) {
    return azimuths[a] < azimuths[b];
  });
  std::vector<int> counts(azimuths.size(), 0);
  for (std::size_t i = 0; i < azimuths.size(); ++i) {
    const double limit = std::min(options.range_ratio * ranges[i], ranges[i] - options.range_gap);
    auto candidate = std::lower_bound(
        hiding.begin(), hiding.end(), azimuths[i] - options.azimuth, [&](std::size_t a, double v) {
          return azimuths[a] < v;
        });
    for (; candidate != hiding.end() && azimuths[*candidate] <= azimuths[i] + options.azimuth;
         ++candidate) {
      if (ranges[*candidate] < limit) ++counts[i];
    }
  }
  return counts;
}

}  // namespace radive
