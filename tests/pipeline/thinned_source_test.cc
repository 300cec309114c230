// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/thinned_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "tests/pipeline/fake_scan_source.h"

namespace radive {
namespace {

std::vector<std::vector<double>> Ranges(double share, int seed, int skip = 0) {
  std::vector<RadarScan> whole;
  for (int i = 0; i < 200; ++i) {
    whole.push_back(testing::StaticScan(100'000'000LL * i, {5.0, 0.0, 0.0}, 1.0));
  }
  ThinnedSource source(std::make_unique<testing::FakeScanSource>(whole), share, seed);
  EXPECT_EQ(source.Skip(skip), ScanSource::Status::kScan);
  std::vector<std::vector<double>> scans;
  RadarScan scan;
  while (source.Next(&scan) == ScanSource::Status::kScan) {
    scans.emplace_back();
    for (const RadarReturn& ret : scan.returns) scans.back().push_back(ret.position.norm());
  }
  return scans;
}

TEST(ThinnedSource, LeavesOutTheShareAndKeepsTheOrder) {
  const auto scans = Ranges(0.25, 3);
  ASSERT_EQ(scans.size(), 200u);
  std::size_t num_kept = 0;
  for (const auto& ranges : scans) {
    num_kept += ranges.size();
    for (std::size_t i = 1; i < ranges.size(); ++i) EXPECT_LT(ranges[i - 1], ranges[i]);
  }
  // 8,000 returns: the standard deviation of the share is 0.005.
  EXPECT_NEAR(static_cast<double>(num_kept) / 8000.0, 0.75, 0.02);
  EXPECT_NE(scans[0], scans[1]);
}

TEST(ThinnedSource, DependsOnSeedAndStampAlone) {
  const auto all = Ranges(0.25, 3);
  const auto later = Ranges(0.25, 3, 7);
  ASSERT_EQ(later.size(), 193u);
  for (std::size_t i = 0; i < later.size(); ++i) EXPECT_EQ(later[i], all[i + 7]);
  EXPECT_NE(Ranges(0.25, 4)[0], all[0]);
}

}  // namespace
}  // namespace radive
