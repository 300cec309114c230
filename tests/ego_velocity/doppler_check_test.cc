// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/doppler_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "radive/sensor/doppler_wrap.h"
#include "radive/util/random.h"
#include "tests/pipeline/fake_scan_source.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::ScanOfPosts;
using testing::StaticScan;
using testing::StaticScans;

const Eigen::Vector3d kForward(8.0, 0.5, -0.2);

// Doppler as it should be -> as a file has it.
using Fault = std::function<double(const RadarReturn&)>;

std::vector<RadarScan> Faulty(std::vector<RadarScan> scans, const Fault& fault) {
  for (RadarScan& scan : scans) {
    for (RadarReturn& ret : scan.returns) ret.doppler = fault(ret);
  }
  return scans;
}

DopplerCheck Checked(const std::vector<RadarScan>& scans,
                     DopplerCheck::Sign sign = DopplerCheck::Sign::kUnknown,
                     const SensorOptions& sensor = SensorOptions()) {
  DopplerCheck check(sensor, PreprocessingOptions(), sign);
  for (const RadarScan& scan : scans) check.Add(scan);
  return check;
}

// The warning of a drive of 4 s with that fault, which must switch the Doppler off.
std::string WarningOf(const Fault& fault) {
  DopplerCheck check = Checked(Faulty(StaticScans(40, kForward, 1.0), fault));
  EXPECT_EQ(check.Factor(0), 0);
  const auto remarks = check.TakeRemarks();
  if (remarks.size() != 1) return std::to_string(remarks.size()) + " remarks";
  EXPECT_TRUE(remarks[0].is_warning);
  return remarks[0].text;
}

TEST(DopplerCheck, FindsTheSignWhicheverWayTheRadarMoves) {
  const Eigen::Vector3d left(0.0, 6.0, 0.0);
  for (const Eigen::Vector3d& v : {kForward, Eigen::Vector3d(-kForward), left}) {
    for (const double sign : {1.0, -1.0}) {
      DopplerCheck check = Checked(StaticScans(40, v, sign));
      EXPECT_EQ(check.Factor(0), sign > 0 ? 1 : -1) << v.transpose();
      const auto remarks = check.TakeRemarks();
      ASSERT_EQ(remarks.size(), 1u);
      EXPECT_FALSE(remarks[0].is_warning) << remarks[0].text;
    }
  }
}

// Two spans of 3.866 m/s make 8 m/s: what is left of it says nothing by itself.
TEST(DopplerCheck, FindsTheSignOfDopplerThatWraps) {
  SensorOptions sensor;
  sensor.doppler_span = 3.866;
  for (const double sign : {1.0, -1.0}) {
    const auto scans = Faulty(StaticScans(40, kForward, sign), [&](const RadarReturn& ret) {
      return WrapDoppler(ret.doppler, sensor.doppler_span);
    });
    EXPECT_EQ(Checked(scans, DopplerCheck::Sign::kUnknown, sensor).Factor(0), sign > 0 ? 1 : -1);
  }
}

TEST(DopplerCheck, NamesTheUnit) {
  EXPECT_THAT(WarningOf([](const RadarReturn& ret) { return 3.6 * ret.doppler; }),
              HasSubstr("Doppler speed is 3.6 times the motion of the points: km/h?; Doppler is "
                        "switched off"));
  EXPECT_THAT(WarningOf([](const RadarReturn& ret) { return 100.0 * ret.doppler; }),
              HasSubstr(" times the motion of the points: cm/s?"));
  EXPECT_THAT(WarningOf([](const RadarReturn& ret) { return -2.237 * ret.doppler; }),
              HasSubstr("-2.2 times the motion of the points: mph?"));
}

TEST(DopplerCheck, DopplerOfNoMotionWhileThePointsMove) {
  EXPECT_THAT(WarningOf([](const RadarReturn&) { return 0.0; }),
              HasSubstr("says 0.00 m/s where the points move at 8"));
}

TEST(DopplerCheck, DopplerThatMakesNoSense) {
  Random random(3);
  EXPECT_THAT(WarningOf([&](const RadarReturn&) { return random.Uniform(-15.0, 15.0); }),
              HasSubstr("Doppler makes no sense"));
  EXPECT_THAT(WarningOf([](const RadarReturn&) { return std::nan(""); }),
              HasSubstr("Doppler is no number in 10 of 10 scans"));
}

TEST(DopplerCheck, AGivenSignIsCheckedTooAndNotTurned) {
  DopplerCheck right = Checked(StaticScans(40, kForward, 1.0), DopplerCheck::Sign::kGiven);
  EXPECT_EQ(right.Factor(0), 1);
  DopplerCheck wrong = Checked(StaticScans(40, kForward, -1.0), DopplerCheck::Sign::kGiven);
  EXPECT_EQ(wrong.Factor(0), 0);
  EXPECT_THAT(wrong.TakeRemarks().at(0).text, HasSubstr("opposite sign"));
}

TEST(DopplerCheck, ADriveThatStandsSaysNothing) {
  const std::vector<RadarScan> scans = StaticScans(60, Eigen::Vector3d::Zero(), 1.0);
  DopplerCheck check = Checked(scans);
  EXPECT_FALSE(check.IsDecided(0));
  EXPECT_TRUE(check.IsStanding(scans[50]));
  EXPECT_TRUE(check.TakeRemarks().empty());
}

// A car passes a radar that stands: a third of the returns has its speed.
TEST(DopplerCheck, MovingReturnsRaiseNoAlarm) {
  std::vector<RadarScan> scans = StaticScans(60, kForward, 1.0);
  for (RadarScan& scan : scans) {
    for (std::size_t i = 0; i < scan.returns.size(); i += 3) scan.returns[i].doppler += 7.0;
  }
  EXPECT_EQ(Checked(scans).Factor(0), 1);
}

TEST(DopplerCheck, ARadarThatCannotTellGoesByTheOthers) {
  std::vector<RadarScan> scans;
  for (const RadarScan& scan : StaticScans(40, kForward, -1.0)) {
    scans.push_back(scan);
    scans.push_back(scan);
    scans.back().radar = 2;
    scans.back().returns.resize(8);
  }
  DopplerCheck check = Checked(scans);
  EXPECT_EQ(check.Factor(0), -1);
  EXPECT_EQ(check.Factor(2), -1);
}

TEST(DopplerCheck, AnAssumedSignIsThatOfDrivingForward) {
  // A single scan says how fast, and nothing of the motion of the points.
  for (const double mount_yaw : {0.0, 3.141592653589793}) {
    SensorOptions sensor;
    sensor.mount_yaw = mount_yaw;
    DopplerCheck check(sensor, PreprocessingOptions());
    const double forward = mount_yaw == 0.0 ? 1.0 : -1.0;
    check.Add(ScanOfPosts(0, Eigen::Vector3d::Zero(), forward * kForward, -1.0));
    check.Assume(0);
    EXPECT_EQ(check.Factor(0), -1);
    EXPECT_FALSE(check.TakeRemarks().at(0).is_warning);
    check.Conclude();
    const auto remarks = check.TakeRemarks();
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_TRUE(remarks[0].is_warning);
    EXPECT_THAT(remarks[0].text, HasSubstr("-1 assumed: the vehicle then drives forward"));
  }
}

// Two pairs of scans do not tell, some more do: what was only assumed is no warning any more.
TEST(DopplerCheck, NoWarningOfWhatWasDecidedInTheEnd) {
  const std::vector<RadarScan> scans = StaticScans(40, kForward, 1.0);
  DopplerCheck check = Checked({scans.begin(), scans.begin() + 5});
  check.Assume(0);
  for (std::size_t i = 5; i < scans.size(); ++i) check.Add(scans[i]);
  check.Finish();
  const auto remarks = check.TakeRemarks();
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_THAT(remarks[0].text, HasSubstr("so far Doppler sign undecided"));
  EXPECT_THAT(remarks[1].text, HasSubstr("Doppler sign +1: by the motion of the points"));
  EXPECT_FALSE(remarks[0].is_warning || remarks[1].is_warning);
}

// In km/h it is left out; 8, 0.5 m/s by the points, also for scans before that was known.
TEST(DopplerCheck, TellsTheMotionOfThePointsWhereTheDopplerIsLeftOut) {
  SensorOptions sensor;
  sensor.mount_yaw = 0.5;
  const auto scans = Faulty(StaticScans(40, kForward, 1.0),
                            [](const RadarReturn& ret) { return 3.6 * ret.doppler; });
  const DopplerCheck check = Checked(scans, DopplerCheck::Sign::kUnknown, sensor);
  ASSERT_EQ(check.Factor(0), 0);
  for (const std::size_t i : {0u, 10u, 39u}) {
    const auto v_radar = check.MotionOfPoints(scans[i]);
    ASSERT_TRUE(v_radar);
    EXPECT_LT((*v_radar - Eigen::Vector3d(8.0, 0.5, 0.0)).norm(), 0.3) << v_radar->transpose();
  }
  const DopplerCheck healthy = Checked(StaticScans(40, kForward, 1.0));
  EXPECT_FALSE(healthy.MotionOfPoints(scans[0]));
}

// 20 s of the right sign, then of the wrong one: it says so and goes along.
TEST(DopplerCheck, ChangesWhatItSaidWhenTheEvidenceTurns) {
  std::vector<RadarScan> scans = StaticScans(1500, kForward, 1.0);
  for (std::size_t i = 200; i < scans.size(); ++i) {
    for (RadarReturn& ret : scans[i].returns) ret.doppler = -ret.doppler;
  }
  DopplerCheck check = Checked(scans);
  EXPECT_EQ(check.Factor(0), -1);
  const auto remarks = check.TakeRemarks();
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_TRUE(remarks[1].is_warning);
  EXPECT_THAT(remarks[1].text, HasSubstr("from here on"));
}

// Looked at again when something has changed, 3 s do: between its looks it would take up to 15 s.
TEST(DopplerCheck, LooksAgainAtOnceWhenAskedTo) {
  Random random(3);
  const Fault faults[] = {[](const RadarReturn& ret) { return -ret.doppler; },
                          [](const RadarReturn&) { return 0.0; },
                          [&](const RadarReturn&) { return random.Uniform(-15.0, 15.0); }};
  const int factors[] = {-1, 0, 0};
  const std::vector<RadarScan> healthy = StaticScans(270, kForward, 1.0);
  for (int k = 0; k < 3; ++k) {
    DopplerCheck check = Checked({healthy.begin(), healthy.begin() + 200});
    ASSERT_EQ(check.Factor(0), 1);
    check.TakeRemarks();
    check.LookAgain(0);
    const std::vector<RadarScan> rest = Faulty({healthy.begin() + 200, healthy.end()}, faults[k]);
    for (const RadarScan& scan : rest) check.Add(scan);
    EXPECT_EQ(check.Factor(0), factors[k]) << k;
    const auto remarks = check.TakeRemarks();
    ASSERT_EQ(remarks.size(), 1u);
    EXPECT_TRUE(remarks[0].is_warning);
    EXPECT_THAT(remarks[0].text, HasSubstr("from here on, after other evidence before"));
  }
  DopplerCheck check = Checked({healthy.begin(), healthy.begin() + 200});
  check.TakeRemarks();
  check.LookAgain(0);
  for (std::size_t i = 200; i < healthy.size(); ++i) check.Add(healthy[i]);
  EXPECT_EQ(check.Factor(0), 1);
  EXPECT_TRUE(check.TakeRemarks().empty());
}

TEST(FitDoppler, FindsTheVelocityAmongMovingReturns) {
  RadarScan scan = StaticScan(0, kForward, 1.0);
  for (std::size_t i = 0; i < scan.returns.size(); i += 3) scan.returns[i].doppler += 5.0;
  const DopplerFit fit = FitDoppler(scan, SensorOptions());
  ASSERT_TRUE(fit.v_plus);
  EXPECT_LT((*fit.v_plus - kForward).norm(), 0.01);
  EXPECT_EQ(*fit.v_minus, -*fit.v_plus);
  EXPECT_EQ(fit.num_inliers, 26);  // of 40, of which 14 move
}

TEST(FitDoppler, FindsTheVelocityInAnyUnit) {
  RadarScan scan = StaticScan(0, 100.0 * kForward, 1.0);
  for (std::size_t i = 0; i < scan.returns.size(); ++i) {
    scan.returns[i].doppler += i % 2 == 0 ? 10.0 : -10.0;  // 0.1 m/s in cm/s
  }
  const DopplerFit fit = FitDoppler(scan, SensorOptions());
  ASSERT_TRUE(fit.v_plus);
  EXPECT_NEAR(fit.v_plus->x(), 800.0, 10.0);
  EXPECT_EQ(fit.num_inliers, 40);
}

TEST(FitDoppler, RefusesFewOrDisagreeingReturns) {
  RadarScan scan = StaticScan(0, kForward, 1.0);
  for (std::size_t i = 0; i < scan.returns.size(); ++i) {
    scan.returns[i].doppler = i % 2 == 0 ? 3.0 * static_cast<double>(i) : -30.0;
  }
  EXPECT_LT(FitDoppler(scan, SensorOptions()).num_inliers, 25);
  scan = StaticScan(0, kForward, 1.0);
  scan.returns.resize(5);
  EXPECT_FALSE(FitDoppler(scan, SensorOptions()).v_plus);
}

}  // namespace
}  // namespace radive
