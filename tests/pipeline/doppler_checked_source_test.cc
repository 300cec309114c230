// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/doppler_checked_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/pipeline/fake_scan_source.h"

namespace radive {
namespace {

using testing::FakeScanSource;
using ::testing::HasSubstr;
using testing::kForward;
using testing::ScanOfPosts;
using testing::StaticScans;

DopplerCheck NewCheck() { return DopplerCheck(SensorOptions(), PreprocessingOptions()); }

std::vector<RadarScan> ReadAll(ScanSource* source) {
  std::vector<RadarScan> scans;
  RadarScan scan;
  while (source->Next(&scan) == ScanSource::Status::kScan) scans.push_back(scan);
  return scans;
}

// Range rate of the post that the radar approaches most: -8 m/s at 8 m/s.
double Fastest(const RadarScan& scan) {
  double fastest = 0.0;
  for (const RadarReturn& ret : scan.returns) {
    if (std::abs(ret.doppler) > std::abs(fastest) && ret.position.x() > 0) fastest = ret.doppler;
  }
  return fastest;
}

TEST(DopplerCheckedSource, TurnsTheWrongSignFromTheFirstScanOn) {
  FakeScanSource inner(StaticScans(40, kForward, -1.0));
  DopplerCheckedSource source(&inner, NewCheck());
  const std::vector<RadarScan> scans = ReadAll(&source);
  ASSERT_EQ(scans.size(), 40u);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    EXPECT_EQ(scans[i].stamp_ns, 100'000'000LL * static_cast<std::int64_t>(i));
    EXPECT_LT(Fastest(scans[i]), -7.0);
  }
  EXPECT_EQ(source.check().Factor(0), -1);
  const auto remarks = source.TakeRemarks();
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_FALSE(remarks[0].is_warning);
  EXPECT_THAT(remarks[0].text, HasSubstr("Doppler sign -1"));
}

TEST(DopplerCheckedSource, ADriveInReverseKeepsTheRightSign) {
  FakeScanSource inner(StaticScans(40, -kForward, 1.0));
  DopplerCheckedSource source(&inner, NewCheck());
  EXPECT_GT(Fastest(ReadAll(&source)[0]), 7.0);
}

TEST(DopplerCheckedSource, ScansOfARadarThatStandsGoOn) {
  std::vector<RadarScan> scans = StaticScans(500, Eigen::Vector3d::Zero(), -1.0);
  for (int i = 0; i < 40; ++i) {
    scans.push_back(ScanOfPosts(
        100'000'000LL * (500 + i), 0.1 * i * kForward, kForward, /*doppler_sign=*/-1.0));
  }
  FakeScanSource inner(scans);
  DopplerCheckedSource source(&inner, NewCheck());
  RadarScan scan;
  for (int i = 0; i < 490; ++i) {
    ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
    EXPECT_LE(inner.num_read(), static_cast<std::size_t>(i) + 12);  // the memory is bounded
  }
  const std::vector<RadarScan> rest = ReadAll(&source);
  ASSERT_EQ(rest.size(), 50u);
  EXPECT_LT(Fastest(rest[12]), -7.0);  // the third that moves
}

TEST(DopplerCheckedSource, HoldsNoMoreScansBackThanItsBound) {
  // Posts that keep their places although the Doppler says 8 m/s to the front or to the side in
  // turn, and that are too few to tell: the sign stays open.
  std::vector<RadarScan> scans = StaticScans(100, kForward, 1.0);
  for (RadarScan& scan : scans) scan.returns.resize(9);
  FakeScanSource inner(scans);
  DopplerCheckedSource source(&inner, NewCheck());
  RadarScan scan;
  ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_LE(inner.num_read(), DopplerCheckedSource::kMostHeldBack);
}

TEST(DopplerCheckedSource, SaysSoWhenTheRadarNeverMoves) {
  FakeScanSource inner(StaticScans(20, Eigen::Vector3d::Zero(), 1.0));
  DopplerCheckedSource source(&inner, NewCheck());
  EXPECT_EQ(ReadAll(&source).size(), 20u);
  const auto remarks = source.TakeRemarks();
  ASSERT_EQ(remarks.size(), 1u);
  EXPECT_TRUE(remarks[0].is_warning);
  EXPECT_THAT(remarks[0].text, HasSubstr("undecided, +1 assumed: the radar does not move"));
}

TEST(DopplerCheckedSource, ScansWithoutNumbersGoByTheirPointsAndAreCounted) {
  std::vector<RadarScan> scans = StaticScans(60, kForward, 1.0);
  for (std::size_t i = 40; i < 50; ++i) {
    scans[i].place = "scan " + std::to_string(i);
    for (RadarReturn& ret : scans[i].returns) ret.doppler = std::nan("");
  }
  scans[50].returns[0].doppler = std::nan("");  // one of many
  FakeScanSource inner(scans);
  DopplerCheckedSource source(&inner, NewCheck());
  const std::vector<RadarScan> read = ReadAll(&source);
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].has_doppler, i < 40 || i >= 50) << i;
  }
  source.Conclude();
  const auto remarks = source.TakeRemarks();
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_TRUE(remarks[1].is_warning);
  EXPECT_THAT(remarks[1].text, HasSubstr("no number in 10 of 60 scans"));
  EXPECT_THAT(remarks[1].text, HasSubstr("the first: scan 40"));
}

// 20 s of the right sign, then of the wrong one: 7 s do where the velocities are told.
TEST(DopplerCheckedSource, LooksAgainWhereScansHaveNoVelocity) {
  std::vector<RadarScan> scans = StaticScans(270, kForward, 1.0);
  for (std::size_t i = 200; i < scans.size(); ++i) {
    for (RadarReturn& ret : scans[i].returns) ret.doppler = -ret.doppler;
  }
  for (const bool are_told : {true, false}) {
    FakeScanSource inner(scans);
    DopplerCheckedSource source(&inner, NewCheck());
    RadarScan scan;
    for (int i = 0; source.Next(&scan) == ScanSource::Status::kScan; ++i) {
      EgoVelocity velocity;
      velocity.valid = i < 200;
      if (are_told) source.AddVelocity(scan, velocity);
    }
    EXPECT_EQ(source.check().Factor(0), are_told ? -1 : 1);
  }
}

TEST(DopplerCheckedSource, DeliversWhatCameBeforeAnError) {
  FakeScanSource inner(StaticScans(3, kForward, 1.0), "FILE: broken");
  DopplerCheckedSource source(&inner, NewCheck());
  RadarScan scan;
  for (int i = 0; i < 3; ++i) ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(source.Next(&scan), ScanSource::Status::kError);
  EXPECT_EQ(source.error(), "FILE: broken");
}

}  // namespace
}  // namespace radive
