// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/motion_fusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

namespace radive {
namespace {

constexpr std::int64_t kMs = 1'000'000;

double Seconds(std::int64_t stamp_ns) { return 1e-9 * static_cast<double>(stamp_ns); }

Twist Rate(double yaw_rate, double speed, double sideways = 0.0) {
  Twist rate;
  rate << 0.0, 0.0, yaw_rate, speed, sideways, 0.0;
  return rate;
}

Matrix6d Covariance(double sigma_rotation, double sigma_translation) {
  Twist variance;
  variance << Eigen::Vector3d::Constant(sigma_rotation * sigma_rotation),
      Eigen::Vector3d::Constant(sigma_translation * sigma_translation);
  return variance.asDiagonal();
}

double Error(const Rigid3& a, const Rigid3& b) {
  const Rigid3 between = a.Inverse() * b;
  return between.translation.norm() + RotationVector(between.rotation).norm();
}

// Radars that each believe in a constant twist of the body.
struct Believer {
  Twist rate;
  Matrix6d covariance;
  std::int64_t interval_ns, first_ns;
};

// Lets time pass from `begin_ns` to `end_ns`, both excluded, in steps of a millisecond.
void Drive(const std::map<int, Believer>& radars,
           std::int64_t begin_ns,
           std::int64_t end_ns,
           MotionFusion* fusion) {
  for (std::int64_t stamp = begin_ns + kMs; stamp < end_ns; stamp += kMs) {
    for (const auto& [number, radar] : radars) {
      if (stamp < radar.first_ns || (stamp - radar.first_ns) % radar.interval_ns != 0) continue;
      const Rigid3 T_own_body = MotionAlong(Seconds(stamp - radar.first_ns) * radar.rate);
      fusion->Add(number, stamp, T_own_body, radar.covariance, radar.rate.tail<3>());
    }
  }
}

TEST(MotionFusion, OneRadarIsRepeated) {
  MotionFusion fusion;
  Rigid3 T_own_body;
  for (std::int64_t k = 0; k < 30; ++k) {
    fusion.Add(7, k * 70 * kMs, T_own_body, Covariance(0.01, 0.02));
    EXPECT_LT(Error(fusion.T_world_body(), T_own_body), 1e-12) << k;
    if (k > 0) {
      EXPECT_LT((fusion.covariance() - Covariance(0.01, 0.02)).norm(), 1e-12);
    }
    const double wobble = std::sin(static_cast<double>(k));
    T_own_body = T_own_body * MotionAlong(0.07 * Rate(0.3 * wobble, 8.0 + wobble, 0.2));
  }
}

// Where all agree, the pose at each scan is exact, whatever their times and weights.
TEST(MotionFusion, RadarsThatAgreeAreRepeated) {
  const Twist rate = Rate(0.3, 8.0);
  MotionFusion fusion;
  fusion.Add(1, 0, Rigid3(), Covariance(0.0, 0.0), rate.tail<3>());
  const std::map<int, Believer> radars = {{1, {rate, Covariance(0.001, 0.01), 70 * kMs, 0}},
                                          {2, {rate, Covariance(0.004, 0.01), 70 * kMs, 19 * kMs}},
                                          {3, {rate, Covariance(0.0, 0.0), 55 * kMs, 19 * kMs}}};
  // The first pose of radars 2 and 3 is by the velocity alone: straight on.
  Drive(radars, 0, 20 * kMs, &fusion);
  EXPECT_LT(Error(fusion.T_world_body(), MotionAlong(0.019 * Rate(0.0, 8.0))), 1e-12);
  // The next stamps are 70 (radar 1), 74 (radar 3), 89 (radar 2).
  for (std::int64_t stamp = 20; stamp < 3'000; ++stamp) {
    Drive(radars, (stamp - 1) * kMs, (stamp + 1) * kMs, &fusion);
    if (stamp % 70 != 0) continue;
    EXPECT_LT(Error(fusion.T_world_body(), MotionAlong(Seconds(stamp * kMs) * rate)), 1e-10);
  }
}

// Twice the standard deviation is a quarter of the weight; rotation and translation have their own.
TEST(MotionFusion, WeighsByVariance) {
  MotionFusion fusion;
  fusion.Add(1, 0, Rigid3(), Covariance(0.0, 0.0));
  fusion.Add(2, 0, Rigid3(), Covariance(0.0, 0.0));
  const std::map<int, Believer> radars = {
      {1, {Rate(0.10, 5.0), Covariance(0.01, 0.2), 50 * kMs, 0}},
      {2, {Rate(0.20, 6.0), Covariance(0.02, 0.2), 50 * kMs, 0}}};
  Drive(radars, 0, 10'001 * kMs, &fusion);
  EXPECT_LT(Error(fusion.T_world_body(), MotionAlong(10.0 * Rate(0.12, 5.5))), 0.01);
  // (0.8 0.01)^2 + (0.2 0.02)^2 of each 50 ms.
  EXPECT_NEAR(fusion.covariance()(2, 2), 0.64e-4 + 0.16e-4, 1e-7);
}

// One of three turns to and fro, and says it is as sure as the others: it comes to count little.
TEST(MotionFusion, FindsOutWhoDisagrees) {
  MotionFusion fusion;
  std::map<int, Rigid3> T_own_body;
  std::vector<double> yaws;
  constexpr int kSwing = 40;  // scans of 50 ms one way
  for (int k = 0; k <= 150 * kSwing; ++k) {
    for (int radar = 1; radar <= 3; ++radar) {
      fusion.Add(radar, k * 50 * kMs, T_own_body[radar], Covariance(0.001, 0.01));
      const double wander = radar < 3 ? 0.0 : (k / kSwing) % 2 == 0 ? 0.05 : -0.05;
      T_own_body[radar] = T_own_body[radar] * MotionAlong(0.05 * Rate(wander, 5.0));
    }
    yaws.push_back(RotationVector(fusion.T_world_body().rotation).z());
  }
  // 0.1 rad a swing, of which it has a third at first.
  EXPECT_NEAR(yaws[kSwing], 0.1 / 3.0, 0.005);
  EXPECT_LT(std::abs(yaws.back() - yaws[yaws.size() - 1 - kSwing]), 0.005);
}

// Two radars drive straight on; at one scan the first has no more than a prediction, which is 0.1
// rad off. Its next step begins at the pose before: nothing of the prediction is left.
TEST(MotionFusion, WhatIsOnlyPredictedIsNoStep) {
  for (const bool is_measured : {false, true}) {
    MotionFusion fusion;
    for (int k = 0; k < 100; ++k) {
      const Rigid3 T_own_body = MotionAlong(0.05 * k * Rate(0.0, 5.0));
      fusion.Add(2, k * 50 * kMs, T_own_body, Covariance(0.001, 0.01));
      const Rigid3 T_wrong = T_own_body * MotionAlong(Rate(0.1, 0.0));
      if (k != 50) {
        fusion.Add(1, k * 50 * kMs, T_own_body, Covariance(0.001, 0.01));
      } else if (is_measured) {
        fusion.Add(1, k * 50 * kMs, T_wrong, Covariance(0.001, 0.01));
      } else {
        fusion.AddPredicted(1, k * 50 * kMs, T_wrong, Covariance(0.001, 0.01));
      }
      const double yaw = RotationVector(fusion.T_world_body().rotation).z();
      EXPECT_NEAR(yaw, is_measured && k == 50 ? 0.05 : 0.0, 1e-9) << k;
    }
  }
}

// A radar that is lost for long goes on with what it predicts.
TEST(MotionFusion, LongPredictionsAreSteps) {
  MotionFusion fusion;
  for (int k = 0; k < 20; ++k) {
    const Rigid3 T_own_body = MotionAlong(0.05 * k * Rate(0.0, k < 10 ? 5.0 : 4.0));
    if (k < 10) {
      fusion.Add(1, k * 50 * kMs, T_own_body, Covariance(0.001, 0.01));
    } else {
      fusion.AddPredicted(1, k * 50 * kMs, T_own_body, Covariance(0.001, 0.01));
    }
    // The first two of these go on at 5 m/s; the third is taken.
    if (k == 11) {
      EXPECT_NEAR(fusion.T_world_body().translation.x(), 0.05 * 11 * 5.0, 1e-9);
    }
    if (k == 12) {
      EXPECT_NEAR(fusion.T_world_body().translation.x(), 0.05 * 12 * 4.0, 1e-9);
    }
  }
}

// A scan that is unusually sure of itself weighs no more, one that was only predicted weighs less.
TEST(MotionFusion, BelievesNoSingleScan) {
  MotionFusion fusion;
  fusion.Add(1, 0, Rigid3(), Covariance(0.0, 0.0));
  fusion.Add(2, 0, Rigid3(), Covariance(0.0, 0.0));
  const Twist rate = Rate(0.0, 5.0);
  const std::map<int, Believer> radars = {{1, {rate, Covariance(0.01, 0.01), 50 * kMs, 0}},
                                          {2, {rate, Covariance(0.01, 0.01), 50 * kMs, 0}}};
  Drive(radars, 0, 20'001 * kMs, &fusion);
  const auto yaw_after = [&](const Matrix6d& covariance) {
    MotionFusion copy = fusion;
    copy.Add(1, 20'050 * kMs, MotionAlong(20.05 * rate), Covariance(0.01, 0.01));
    copy.Add(
        2, 20'050 * kMs, MotionAlong(20.0 * rate) * MotionAlong(0.05 * Rate(1.0, 5.0)), covariance);
    return RotationVector(copy.T_world_body().rotation).z();
  };
  EXPECT_NEAR(yaw_after(Covariance(0.01, 0.01)), 0.025, 1e-6);
  EXPECT_NEAR(yaw_after(Covariance(0.0001, 0.0001)), 0.025, 1e-4);
  EXPECT_LT(yaw_after(Covariance(1.0, 1.0)), 0.001);
}

// A radar that falls silent is not waited for, and takes part again when it comes back.
TEST(MotionFusion, GoesOnWithoutASilentRadar) {
  MotionFusion fusion;
  fusion.Add(1, 0, Rigid3(), Covariance(0.0, 0.0));
  fusion.Add(2, 0, Rigid3(), Covariance(0.0, 0.0));
  Believer first = {Rate(0.0, 4.0), Covariance(0.01, 0.01), 50 * kMs, 0};
  Believer second = {Rate(0.0, 6.0), Covariance(0.01, 0.01), 50 * kMs, 0};
  Drive({{1, first}, {2, second}}, 0, 1'001 * kMs, &fusion);
  EXPECT_NEAR(fusion.T_world_body().translation.x(), 5.0, 1e-6);
  Drive({{1, first}}, 1'001 * kMs, 3'001 * kMs, &fusion);
  // For two intervals of waiting radar 1 was alone, but not settled.
  EXPECT_NEAR(fusion.T_world_body().translation.x(), 5.0 + 8.0, 0.01);
  Drive({{1, first}, {2, second}}, 3'001 * kMs, 4'001 * kMs, &fusion);
  EXPECT_NEAR(fusion.T_world_body().translation.x(), 5.0 + 8.0 + 5.0, 0.06);
}

}  // namespace
}  // namespace radive
