// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/innovation_gate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "radive/odometry/odometry.h"
#include "radive/util/angle_units.h"
#include "radive/util/random.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Rigid3 Turned(double degrees, const Eigen::Vector3d& translation = Eigen::Vector3d::Zero()) {
  return {QuaternionFromRotationVector({0.0, 0.0, Radians(degrees)}), translation};
}

// A vehicle at 1 m a scan along x, predicted exactly; `innovation` is what registration says.
class Gate {
 public:
  explicit Gate(double gate) : gate_(gate) {}

  std::string Scan(const Rigid3& innovation, double num_intervals = 1.0) {
    const Rigid3 predicted = Predicted();
    const Rigid3 registered = predicted * innovation;
    const std::string reason = gate_.Check(last_, predicted, registered, num_intervals);
    last_ = reason.empty() ? registered : predicted;
    return reason;
  }
  // Twelve scans with innovations of `degrees` and `metres`.
  void Learn(double degrees, double metres) {
    for (int i = 0; i < 12; ++i) {
      const double sign = i % 2 == 0 ? 1.0 : -1.0;
      ASSERT_THAT(Scan(Turned(sign * degrees, {0.0, sign * metres, 0.0})), IsEmpty());
    }
  }
  Rigid3 Predicted() const { return last_ * Turned(0.0, {1.0, 0.0, 0.0}); }
  const InnovationGate& gate() const { return gate_; }

 private:
  InnovationGate gate_;
  Rigid3 last_;
};

TEST(InnovationGate, FollowsTheMedian) {
  // Five times 1 deg and 0.1 m.
  for (const bool is_above : {false, true}) {
    Gate rotation(5.0), translation(5.0);
    rotation.Learn(1.0, 0.1);
    EXPECT_EQ(rotation.Scan(Turned(is_above ? 5.1 : 4.9)).empty(), !is_above);
    translation.Learn(1.0, 0.1);
    EXPECT_EQ(translation.Scan(Turned(0.0, {0.0, is_above ? 0.51 : 0.49, 0.0})).empty(), !is_above);
  }
}

TEST(InnovationGate, AllowsWhatAVehicleCanDoAfterAStillDrive) {
  Gate gate(5.0);
  gate.Learn(0.0, 0.0);
  EXPECT_THAT(gate.Scan(Turned(1.1, {0.0, 0.19, 0.0})), IsEmpty());
  EXPECT_THAT(gate.Scan(Turned(1.2)),
              HasSubstr("1.20 deg and 0.00 m from the prediction, at most 1.15 and 0.20"));
}

TEST(InnovationGate, GrowsWithTheTimeBetweenScans) {
  for (const double num_intervals : {1.0, 3.0}) {
    Gate gate(5.0);
    gate.Learn(1.0, 0.1);
    EXPECT_EQ(gate.Scan(Turned(14.0), num_intervals).empty(), num_intervals == 3.0);
  }
}

TEST(InnovationGate, IsOffAtZeroAndBeforeItKnowsTheDrive) {
  Gate off(0.0), young(5.0);
  off.Learn(0.1, 0.01);
  EXPECT_THAT(off.Scan(Turned(90.0)), IsEmpty());
  EXPECT_THAT(young.Scan(Turned(90.0)), IsEmpty());
}

// One scan that is 10 deg wrong is refused; the next, where it was predicted, is believed.
TEST(InnovationGate, RefusesASingleScan) {
  Gate gate(5.0);
  gate.Learn(0.2, 0.02);
  EXPECT_THAT(gate.Scan(Turned(10.0)), HasSubstr("contradicts the motion"));
  EXPECT_THAT(gate.Scan(Turned(0.2)), IsEmpty());
  EXPECT_FALSE(gate.gate().T_world_corrected());
}

// Two scans that agree with each other, though not with the prediction: the vehicle was quick.
TEST(InnovationGate, BelievesTheSecondScanThatFollowsFromTheFirst) {
  Gate gate(5.0);
  gate.Learn(0.2, 0.02);
  const Rigid3 first = gate.Predicted() * Turned(10.0);
  EXPECT_THAT(gate.Scan(Turned(10.0)), HasSubstr("contradicts"));
  // Where the first scan's pose leads by the motion that is predicted, 1 m ahead.
  const Rigid3 second = first * Turned(0.0, {1.0, 0.0, 0.0});
  EXPECT_THAT(gate.Scan(gate.Predicted().Inverse() * second), IsEmpty());
  ASSERT_TRUE(gate.gate().T_world_corrected());
  EXPECT_NEAR(
      (gate.gate().T_world_corrected()->translation - first.translation).norm(), 0.0, 1e-12);
  EXPECT_THAT(gate.Scan(Turned(0.1)), IsEmpty());
  EXPECT_FALSE(gate.gate().T_world_corrected());
}

// Predictions that have become poor are no reason to refuse every other scan.
TEST(InnovationGate, LearnsAnewAfterARefusalThatWasWrong) {
  Gate gate(5.0);
  gate.Learn(0.2, 0.02);
  int num_refused = 0;
  for (int i = 0; i < 40; ++i) num_refused += gate.Scan(Turned(1.5)).empty() ? 0 : 1;
  EXPECT_EQ(num_refused, 1);
}

// Whatever happens, after three scans registration is believed again.
TEST(InnovationGate, NeverRefusesForLong) {
  Gate gate(5.0);
  gate.Learn(0.2, 0.02);
  EXPECT_THAT(gate.Scan(Turned(10.0)), HasSubstr("contradicts"));
  EXPECT_THAT(gate.Scan(Turned(-20.0)), HasSubstr("contradicts"));
  EXPECT_THAT(gate.Scan(Turned(30.0)), HasSubstr("contradicts"));
  EXPECT_THAT(gate.Scan(Turned(-40.0)), IsEmpty());
}

// A street along x, seen from 1 m further on in each scan, without Doppler; the 20th scan is turned
// by 10 degrees. The largest error of a scan's heading [deg].
double WorstHeading(double innovation_gate) {
  Random random(5);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 600; ++i) {
    const double side = random.Uniform() < 0.5 ? -1.0 : 1.0;
    points.emplace_back(120.0 * random.Uniform(), side * (6.0 + 9.0 * random.Uniform()), 0.0);
  }
  OdometryOptions options;
  options.registration.planar = true;
  options.motion.innovation_gate = innovation_gate;
  Odometry odometry(options);
  double worst = 0.0;
  for (int i = 0; i < 30; ++i) {
    RadarScan scan;
    scan.stamp_ns = 100'000'000LL * i;
    for (const Eigen::Vector3d& point : points) {
      RadarReturn entry;
      entry.position = point - Eigen::Vector3d(i, 0.0, 0.0);
      if (entry.position.x() < std::abs(entry.position.y())) continue;
      if (entry.position.norm() > 50.0) continue;
      if (i == 20) entry.position = Turned(10.0).rotation * entry.position;
      scan.returns.push_back(entry);
    }
    const OdometryResult result = odometry.AddScan(scan);
    worst = std::max(worst, Degrees(RotationVector(result.T_world_radar.rotation).norm()));
  }
  return worst;
}

TEST(InnovationGate, ATurnedScanDoesNotTurnTheDrive) {
  EXPECT_LT(WorstHeading(OdometryOptions().motion.innovation_gate), 0.2);
  EXPECT_GT(WorstHeading(0.0), 2.0);
}

}  // namespace
}  // namespace radive
