// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/error_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace radive {
namespace {

TEST(ErrorStatistics, OddCount) {
  // Mean 3, squares 4 + 1 + 36 = 41, deviations from the mean 1 + 4 + 9 = 14.
  const ErrorStatistics s = ComputeErrorStatistics({2.0, 1.0, 6.0});
  EXPECT_EQ(s.count, 3);
  EXPECT_DOUBLE_EQ(s.sse, 41.0);
  EXPECT_DOUBLE_EQ(s.rmse, std::sqrt(41.0 / 3.0));
  EXPECT_DOUBLE_EQ(s.mean, 3.0);
  EXPECT_DOUBLE_EQ(s.median, 2.0);
  EXPECT_DOUBLE_EQ(s.std, std::sqrt(14.0 / 3.0));
  EXPECT_DOUBLE_EQ(s.min, 1.0);
  EXPECT_DOUBLE_EQ(s.max, 6.0);
}

TEST(ErrorStatistics, EvenCountTakesTheMiddleOfTheTwoMiddleValues) {
  EXPECT_DOUBLE_EQ(ComputeErrorStatistics({10.0, 1.0, 4.0, 2.0}).median, 3.0);
}

TEST(ErrorStatistics, EmptyIsZero) {
  const ErrorStatistics s = ComputeErrorStatistics({});
  EXPECT_EQ(s.count, 0);
  EXPECT_EQ(s.rmse, 0.0);
}

}  // namespace
}  // namespace radive
