// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/bootstrap.h"

#include <gtest/gtest.h>

#include <vector>

namespace radive {
namespace {

TEST(Quantile, IsLinearBetweenNeighbours) {
  // numpy.quantile([1, 2, 3, 10], [0, 0.25, 0.5, 0.75, 1]) = 1, 1.75, 2.5, 4.75, 10
  const std::vector<double> values = {10, 1, 3, 2};
  EXPECT_DOUBLE_EQ(Quantile(values, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(Quantile(values, 0.25), 1.75);
  EXPECT_DOUBLE_EQ(Quantile(values, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(Quantile(values, 0.75), 4.75);
  EXPECT_DOUBLE_EQ(Quantile(values, 1.0), 10.0);
  EXPECT_DOUBLE_EQ(Quantile({7.0}, 0.3), 7.0);
}

// The median of three draws from {0, 0, 3} is 3 when at least two of them are: 3 (1/3)^2 (2/3) +
// (1/3)^3 = 0.259, so the interval spans both values. Of seven draws from six 0 and one 3 it needs
// four: about 0.01, so it does not.
TEST(BootstrapMedian, CoversWhatHappensMoreThanFivePercentOfTheTime) {
  const auto wide = BootstrapMedian({{0, 0, 3}}, Draw::kWithinGroups);
  ASSERT_TRUE(wide);
  EXPECT_EQ(wide->low, 0.0);
  EXPECT_EQ(wide->high, 3.0);
  const auto narrow = BootstrapMedian({{0, 0, 0, 0, 0, 0, 3}}, Draw::kWithinGroups);
  ASSERT_TRUE(narrow);
  EXPECT_EQ(narrow->low, 0.0);
  EXPECT_EQ(narrow->high, 0.0);
}

// For n normal values the median has standard deviation 1.2533 / sqrt(n); here values that are
// uniform on 0..1, n = 101: about 0.5 / sqrt(101) = 0.05, so the interval is 0.5 -+ 0.1.
TEST(BootstrapMedian, HasTheWidthOfTheMediansDistribution) {
  std::vector<double> values;
  for (int i = 0; i <= 100; ++i) values.push_back(i / 100.0);
  const auto interval = BootstrapMedian({values}, Draw::kWithinGroups);
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, 0.4, 0.03);
  EXPECT_NEAR(interval->high, 0.6, 0.03);
}

// Three drives that differ much, each with runs that do not: runs alone leave the median where it
// is, other drives could move it anywhere.
TEST(BootstrapMedian, DrawsGroupsAsWell) {
  const std::vector<std::vector<double>> groups = {{1, 1, 1}, {2, 2, 2}, {9, 9, 9}};
  const auto within = BootstrapMedian(groups, Draw::kWithinGroups);
  const auto over = BootstrapMedian(groups, Draw::kGroupsAndWithin);
  ASSERT_TRUE(within && over);
  EXPECT_EQ(within->low, 2.0);
  EXPECT_EQ(within->high, 2.0);
  EXPECT_EQ(over->low, 1.0);
  EXPECT_EQ(over->high, 9.0);
}

TEST(BootstrapMedian, NeedsEnoughToDrawFrom) {
  EXPECT_FALSE(BootstrapMedian({}, Draw::kWithinGroups));
  EXPECT_FALSE(BootstrapMedian({{1}, {2}, {}}, Draw::kWithinGroups));
  EXPECT_FALSE(BootstrapMedian({{1, 2}, {2, 3}, {}}, Draw::kGroupsAndWithin));
  EXPECT_TRUE(BootstrapMedian({{1}, {2}, {3}}, Draw::kGroupsAndWithin));
}

TEST(BootstrapMedian, RepeatsItself) {
  const std::vector<std::vector<double>> groups = {{1, 5, 2, 8}, {4, 4.5, 9}};
  const auto one = BootstrapMedian(groups, Draw::kWithinGroups);
  const auto two = BootstrapMedian(groups, Draw::kWithinGroups);
  EXPECT_EQ(one->low, two->low);
  EXPECT_EQ(one->high, two->high);
}

}  // namespace
}  // namespace radive
