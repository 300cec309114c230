// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace radive {

// The median of the last 100 values: what is usual, whatever a few of them were.
class RecentMedian {
 public:
  void Add(double value) {
    values_.push_back(value);
    if (values_.size() > kLongest) values_.pop_front();
  }
  void Clear() { values_.clear(); }
  // From ten values on.
  bool is_known() const { return values_.size() >= kShortest; }
  // The upper one of two in the middle; 0 without values.
  double Value() const {
    if (values_.empty()) return 0.0;
    std::vector<double> values(values_.begin(), values_.end());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

 private:
  static constexpr std::size_t kShortest = 10;
  static constexpr std::size_t kLongest = 100;
  std::deque<double> values_;
};

}  // namespace radive
