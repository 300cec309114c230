// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/error_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace radive {

ErrorStatistics ComputeErrorStatistics(std::vector<double> errors) {
  ErrorStatistics statistics;
  if (errors.empty()) return statistics;
  std::sort(errors.begin(), errors.end());
  const std::size_t middle = errors.size() / 2;
  const double n = static_cast<double>(errors.size());

  statistics.count = static_cast<int>(errors.size());
  statistics.min = errors.front();
  statistics.max = errors.back();
  statistics.median =
      errors.size() % 2 == 1 ? errors[middle] : 0.5 * (errors[middle - 1] + errors[middle]);
  statistics.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / n;
  statistics.sse = std::inner_product(errors.begin(), errors.end(), errors.begin(), 0.0);
  statistics.rmse = std::sqrt(statistics.sse / n);
  double squared_deviations = 0.0;
  for (const double error : errors) {
    squared_deviations += (error - statistics.mean) * (error - statistics.mean);
  }
  statistics.std = std::sqrt(squared_deviations / n);
  return statistics;
}

}  // namespace radive
