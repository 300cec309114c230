// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Gaps between scans: what the pose claims of the time in which nobody looked.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "radive/odometry/odometry.h"
#include "radive/util/random.h"

namespace radive {
namespace {

using Status = OdometryResult::Status;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kScanInterval = 0.1;  // [s]
constexpr double kRoadSpeed = 8.0;     // [m/s]

// Things at random beside a straight road along x, which look nowhere the same.
std::vector<Eigen::Vector3d> RoadSide() {
  Random random(5);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 3600; ++i) {
    const double side = random.Uniform() < 0.5 ? -1.0 : 1.0;
    points.emplace_back(
        random.Uniform() * 900.0 - 50.0, side * (6.0 + 9.0 * random.Uniform()), 0.0);
  }
  return points;
}

// The odometry of a radar that looks ahead from `x` [m] on the road, scan by scan.
class Road {
 public:
  explicit Road(bool has_doppler = true) : has_doppler_(has_doppler), odometry_(Options()) {}

  OdometryResult See(double time, double x, double speed) {
    RadarScan scan;
    scan.stamp_ns = std::llround(time * 1e9);
    scan.has_doppler = has_doppler_;
    for (const Eigen::Vector3d& point : points_) {
      RadarReturn entry;
      entry.position = point - Eigen::Vector3d(x, 0.0, 0.0);
      if (entry.position.x() < std::abs(entry.position.y()) || entry.position.norm() > 50.0) {
        continue;
      }
      if (has_doppler_) entry.doppler = -speed * entry.position.normalized().x();
      scan.returns.push_back(entry);
    }
    return odometry_.AddScan(scan);
  }

  // `count` scans from `time` and `x` on; the last result.
  OdometryResult Drive(double time, double x, double speed, int count) {
    OdometryResult result;
    for (int i = 0; i < count; ++i) {
      result = See(time + kScanInterval * i, x + speed * kScanInterval * i, speed);
    }
    return result;
  }

  std::vector<std::string> Warnings() { return odometry_.TakeWarnings(); }

 private:
  static OdometryOptions Options() {
    OdometryOptions options;
    options.registration.planar = true;
    return options;
  }

  const bool has_doppler_;
  const std::vector<Eigen::Vector3d> points_ = RoadSide();
  Odometry odometry_;
};

double X(const OdometryResult& result) { return result.T_world_radar.translation.x(); }

TEST(Gap, AShortOneIsBridged) {
  Road road;
  road.Drive(0.0, 0.0, kRoadSpeed, 11);
  EXPECT_THAT(road.Warnings(), IsEmpty());
  const OdometryResult behind = road.See(3.0, 24.0, kRoadSpeed);
  EXPECT_EQ(behind.status, Status::kRegistered);
  EXPECT_NEAR(X(behind), 24.0, 0.1);
  EXPECT_THAT(road.Warnings(),
              ElementsAre(HasSubstr("gap of 2 s without scans before the stamp 3.0")));
}

// Of a minute at 8 m/s ten seconds are claimed, and the usual interval: 80.8 m of 480.8 m. Of the
// other 50 s it may have gone on at 8 m/s.
TEST(Gap, OfALongOneTenSecondsAreClaimed) {
  for (const bool has_doppler : {true, false}) {
    Road road(has_doppler);
    const double before = X(road.Drive(0.0, 0.0, kRoadSpeed, 21));
    const OdometryResult behind = road.See(62.1, 496.8, kRoadSpeed);
    EXPECT_EQ(behind.status, Status::kPredicted);
    EXPECT_NEAR(X(behind) - before, 80.8, 1.0);
    EXPECT_NEAR(std::sqrt(behind.covariance(3, 3)), 415.0, 5.0);  // 400 m, 15 m by acceleration
    EXPECT_TRUE(behind.is_keyframe);
    EXPECT_THAT(road.Warnings(), ElementsAre(HasSubstr("gap of 60.1 s without scans")));
    // The motion behind the gap is as good as ever.
    const OdometryResult later = road.Drive(62.2, 497.6, kRoadSpeed, 10);
    EXPECT_EQ(later.status, Status::kRegistered);
    EXPECT_NEAR(X(later) - X(behind), 8.0, 0.1);
  }
}

// A clock that was set forward: the next scan is where it would have been without.
TEST(Gap, AStepOfTheClockIsSeenInTheScans) {
  Road road;
  road.Drive(0.0, 0.0, kRoadSpeed, 21);
  const OdometryResult behind = road.See(3602.1, 16.8, kRoadSpeed);
  EXPECT_EQ(behind.status, Status::kRegistered);
  EXPECT_NEAR(X(behind), 16.8, 0.1);
  EXPECT_THAT(road.Warnings(), ElementsAre(HasSubstr("fits as if no time had passed")));
}

TEST(Gap, WhatStandsThroughItStaysWhereItIs) {
  Road road;
  road.Drive(0.0, 0.0, 0.0, 11);
  const OdometryResult behind = road.See(601.0, 0.0, 0.0);
  EXPECT_NE(behind.status, Status::kPredicted) << behind.reason;
  EXPECT_NEAR(X(behind), 0.0, 0.01);
  EXPECT_LT(behind.covariance(3, 3), 0.01);
  EXPECT_THAT(road.Warnings(), ElementsAre(HasSubstr("gap of 600 s")));
}

// It stands at both ends, but elsewhere: nobody knows the way.
TEST(Gap, WhatStandsElsewhereIsLost) {
  Road road;
  road.Drive(0.0, 0.0, kRoadSpeed, 21);
  double time = 2.0, x = 16.0;
  for (double speed = kRoadSpeed - 1.0; speed >= 0.0; speed -= 1.0) {
    time += kScanInterval;
    x += kScanInterval * (speed + 0.5);
    road.See(time, x, speed);
  }
  road.Drive(time + kScanInterval, x, 0.0, 11);
  const OdometryResult behind = road.See(602.1, 300.0, 0.0);
  EXPECT_EQ(behind.status, Status::kPredicted);
  EXPECT_GT(std::sqrt(behind.covariance(3, 3)), 300.0);
}

}  // namespace
}  // namespace radive
