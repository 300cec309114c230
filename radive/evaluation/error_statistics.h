// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace radive {

// Statistics of a list of errors, in the errors' own unit (sse in its square).
struct ErrorStatistics {
  int count = 0;
  double rmse = 0.0;
  double mean = 0.0;
  double median = 0.0;  // mean of the two middle values when the count is even
  double std = 0.0;     // about the mean, divided by the count (not by count - 1)
  double min = 0.0;
  double max = 0.0;
  double sse = 0.0;  // sum of squared errors
};

// All zero for an empty list.
ErrorStatistics ComputeErrorStatistics(std::vector<double> errors);

}  // namespace radive
