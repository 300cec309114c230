// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/doppler_sign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "radive/sensor/doppler_wrap.h"
#include "tests/pipeline/fake_scan_source.h"

namespace radive {
namespace {

using testing::FakeScanSource;
using ::testing::HasSubstr;
using testing::StaticScan;
using testing::StaticScans;

const Eigen::Vector3d kForward(8.0, 0.5, -0.2);

TEST(FitVelocity, FindsTheVelocityAmongMovingReturns) {
  RadarScan scan = StaticScan(0, kForward, 1.0);
  for (std::size_t i = 0; i < scan.returns.size(); i += 3) scan.returns[i].doppler += 5.0;
  const auto v_radar = FitVelocity(scan);
  ASSERT_TRUE(v_radar);
  EXPECT_LT((*v_radar - kForward).norm(), 0.01);
}

TEST(FitVelocity, RefusesFewOrDisagreeingReturns) {
  RadarScan scan = StaticScan(0, kForward, 1.0);
  for (std::size_t i = 0; i < scan.returns.size(); ++i) {
    scan.returns[i].doppler = i % 2 == 0 ? 3.0 * static_cast<double>(i) : -30.0;
  }
  EXPECT_FALSE(FitVelocity(scan));
  scan = StaticScan(0, kForward, 1.0);
  scan.returns.resize(5);
  EXPECT_FALSE(FitVelocity(scan));
}

// A return straight ahead comes nearer: its canonical range rate is negative.
TEST(DopplerSignSource, TurnsTheWrongSign) {
  FakeScanSource inner(StaticScans(120, kForward, -1.0));
  DopplerSignSource source(&inner, SensorOptions());
  RadarScan scan;
  for (int i = 0; i < 120; ++i) {
    ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
    EXPECT_EQ(scan.stamp_ns, 100'000'000LL * i);
    const RadarReturn& ahead = scan.returns[20];  // azimuth 0
    EXPECT_LT(ahead.doppler, -7.0);
  }
  EXPECT_EQ(source.Next(&scan), ScanSource::Status::kEnd);
  EXPECT_EQ(source.sign(), -1.0);
  EXPECT_TRUE(source.is_decided());
  EXPECT_THAT(source.evidence(), HasSubstr("Doppler sign -1"));
  EXPECT_THAT(source.evidence(), HasSubstr("-8.00 m/s over 100 moving of the first 100 scans"));
}

// Two spans of 3.866 m/s make 8 m/s: what is left of it says nothing by itself.
TEST(DopplerSignSource, TurnsTheWrongSignOfDopplerThatWraps) {
  std::vector<RadarScan> scans = StaticScans(20, kForward, -1.0);
  SensorOptions sensor;
  sensor.doppler_span = 3.866;
  for (RadarScan& scan : scans) {
    for (RadarReturn& ret : scan.returns) {
      ret.doppler = WrapDoppler(ret.doppler, sensor.doppler_span);
    }
  }
  FakeScanSource inner(scans);
  DopplerSignSource source(&inner, sensor);
  RadarScan scan;
  ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_TRUE(source.is_decided()) << source.evidence();
  EXPECT_EQ(source.sign(), -1.0);
}

TEST(DopplerSignSource, KeepsTheRightSign) {
  FakeScanSource inner(StaticScans(20, kForward, 1.0));
  DopplerSignSource source(&inner, SensorOptions());
  RadarScan scan;
  ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_LT(scan.returns[20].doppler, -7.0);
  EXPECT_EQ(source.sign(), 1.0);
  EXPECT_TRUE(source.is_decided());
}

TEST(DopplerSignSource, JudgesByTheFrontOfTheVehicle) {
  // A radar that looks back: driving forward is driving towards its -x.
  FakeScanSource inner(StaticScans(20, -kForward, 1.0));
  SensorOptions sensor;
  sensor.mount_yaw = 3.141592653589793;
  DopplerSignSource source(&inner, sensor);
  RadarScan scan;
  ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(source.sign(), 1.0);
}

TEST(DopplerSignSource, SaysSoWhenTheRadarStands) {
  FakeScanSource inner(StaticScans(20, Eigen::Vector3d::Zero(), 1.0));
  DopplerSignSource source(&inner, SensorOptions());
  RadarScan scan;
  ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(source.sign(), 1.0);
  EXPECT_FALSE(source.is_decided());
  EXPECT_THAT(source.evidence(), HasSubstr("undecided, +1 assumed"));
}

TEST(DopplerSignSource, DeliversWhatCameBeforeAnError) {
  FakeScanSource inner(StaticScans(3, kForward, 1.0), "FILE: broken");
  DopplerSignSource source(&inner, SensorOptions());
  RadarScan scan;
  for (int i = 0; i < 3; ++i) ASSERT_EQ(source.Next(&scan), ScanSource::Status::kScan);
  EXPECT_EQ(source.Next(&scan), ScanSource::Status::kError);
  EXPECT_EQ(source.error(), "FILE: broken");
}

}  // namespace
}  // namespace radive
