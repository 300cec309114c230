// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/merged_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "tests/io/scan_files.h"
#include "tests/pipeline/fake_scan_source.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using testing::FakeScanSource;
using ::testing::Pair;

// A radar that measures at the given times [ns].
std::unique_ptr<FakeScanSource> RadarWithStamps(const std::vector<std::int64_t>& stamps,
                                                const std::string& error_at_end = "") {
  std::vector<RadarScan> scans;
  for (const std::int64_t stamp : stamps) scans.emplace_back().stamp_ns = stamp;
  return std::make_unique<FakeScanSource>(std::move(scans), error_at_end);
}

std::vector<std::pair<int, std::int64_t>> RadarsAndStamps(const std::vector<RadarScan>& scans) {
  std::vector<std::pair<int, std::int64_t>> rows;
  for (const RadarScan& scan : scans) rows.emplace_back(scan.radar, scan.stamp_ns);
  return rows;
}

TEST(MergedSource, OrdersByStampThenByRadar) {
  std::vector<MergedSource::Radar> radars;
  radars.push_back({RadarWithStamps({10, 40, 70}), 1});
  radars.push_back({RadarWithStamps({5, 40}), 2});
  radars.push_back({RadarWithStamps({}), 7});
  MergedSource merged(std::move(radars));
  EXPECT_EQ(merged.NumScans(), 5);
  EXPECT_THAT(RadarsAndStamps(testing::ReadAll(&merged)),
              ElementsAre(Pair(2, 5), Pair(1, 10), Pair(1, 40), Pair(2, 40), Pair(1, 70)));
}

TEST(MergedSource, PassesOnWarningsAndErrors) {
  auto first = RadarWithStamps({10, 20});
  first->Warn("radar1: something");
  std::vector<MergedSource::Radar> radars;
  radars.push_back({std::move(first), 1});
  radars.push_back({RadarWithStamps({15}, "radar2: broken"), 2});
  MergedSource merged(std::move(radars));
  RadarScan scan;
  ASSERT_EQ(merged.Next(&scan), ScanSource::Status::kScan);
  EXPECT_THAT(merged.TakeWarnings(), ElementsAre("radar1: something"));
  ASSERT_EQ(merged.Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(scan.radar, 2);
  EXPECT_EQ(merged.Next(&scan), ScanSource::Status::kError);
  EXPECT_EQ(merged.error(), "radar2: broken");
}

}  // namespace
}  // namespace radive
