// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Radars at several places of one vehicle, each with its own times.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "radive/odometry/odometry.h"
#include "tests/synthetic_scene.h"

namespace radive {
namespace {

using Status = OdometryResult::Status;

constexpr double kSpeed = 4.0;     // of the rear axle [m/s]
constexpr double kYawRate = 0.15;  // [rad/s]

// Front left, front right, and one that looks back, as rows of sensor.mounts.
const std::vector<double> kMounts = {1, 3.5,  0.8,  0.5, 0, 0, 0.5,   //
                                     2, 3.5,  -0.8, 0.5, 0, 0, -0.5,  //
                                     5, -0.8, 0.0,  0.5, 0, 0, M_PI};

OdometryOptions MountedOptions() {
  OdometryOptions options;
  options.sensor.mounts = kMounts;
  options.registration.planar = true;
  options.motion.body = MotionOptions::Body::kVehicle;
  return options;
}

// Pose of the vehicle at a time [s]: it drives a circle to the left.
Rigid3 VehicleAt(double time) {
  const double yaw = kYawRate * time, radius = kSpeed / kYawRate;
  return {QuaternionFromRotationVector({0.0, 0.0, yaw}),
          {-20.0 + radius * std::sin(yaw), -3.0 + radius * (1.0 - std::cos(yaw)), 0.5}};
}

// Exact returns of what lies before the radar.
RadarScan ScanAt(std::int64_t stamp_ns, int radar) {
  const double time = static_cast<double>(stamp_ns) * 1e-9;
  const Rigid3 T_vehicle_radar = MountedOptions().sensor.ForRadar(radar).T_vehicle_radar();
  const Rigid3 T_radar_world = (VehicleAt(time) * T_vehicle_radar).Inverse();
  const Eigen::Vector3d turn(0.0, 0.0, kYawRate);
  const Eigen::Vector3d v_radar =
      T_vehicle_radar.rotation.conjugate() *
      (Eigen::Vector3d(kSpeed, 0.0, 0.0) + turn.cross(T_vehicle_radar.translation));
  RadarScan scan;
  scan.stamp_ns = stamp_ns;
  scan.radar = radar;
  scan.has_doppler = true;
  for (const Eigen::Vector3d& point : testing::StreetPoints()) {
    RadarReturn entry;
    entry.position = T_radar_world * point;
    if (entry.position.x() < 0.5 * std::abs(entry.position.y())) continue;
    entry.doppler = -entry.position.normalized().dot(v_radar);
    scan.returns.push_back(entry);
  }
  return scan;
}

double VehicleError(const Rigid3& estimate, const Rigid3& truth) {
  return (estimate.translation - truth.translation).norm() +
         RotationVector(estimate.rotation * truth.rotation.conjugate()).norm();
}

// Radar 5 measures with radar 1, at the very same times; radar 2 in between.
TEST(SeveralRadars, FollowTheVehicle) {
  Odometry odometry(MountedOptions());
  const Rigid3 T_first_world = VehicleAt(0.0).Inverse();
  for (std::int64_t k = 0; k < 50; ++k) {
    const std::int64_t stamp = k * 60'000'000;
    for (const auto& [radar, later] :
         std::array<std::pair<int, std::int64_t>, 3>{{{1, 0}, {5, 0}, {2, 23'000'000}}}) {
      const OdometryResult result = odometry.AddScan(ScanAt(stamp + later, radar));
      const Rigid3 truth = T_first_world * VehicleAt(static_cast<double>(stamp + later) * 1e-9);
      EXPECT_EQ(result.status, Status::kRegistered) << k << " " << radar << " " << result.reason;
      EXPECT_LT(VehicleError(result.T_world_body, truth), 0.04) << k << " " << radar;
      const Rigid3 T_vehicle_radar = MountedOptions().sensor.ForRadar(radar).T_vehicle_radar();
      EXPECT_LT(VehicleError(result.T_world_radar, result.T_world_body * T_vehicle_radar), 1e-9);
      EXPECT_TRUE(result.covariance.allFinite());
    }
  }
}

// The radar of the first scan is the body: what the others see moves it.
TEST(SeveralRadars, TheBodyMayBeTheFirstRadar) {
  OdometryOptions options = MountedOptions();
  options.motion.body = MotionOptions::Body::kRadar;
  Odometry odometry(options);
  const Rigid3 T_vehicle_first = options.sensor.ForRadar(2).T_vehicle_radar();
  const Rigid3 T_first_world = (VehicleAt(0.0) * T_vehicle_first).Inverse();
  for (int k = 0; k < 60; ++k) {
    const std::int64_t stamp = k * 30'000'000;
    const OdometryResult result = odometry.AddScan(ScanAt(stamp, k % 2 == 0 ? 2 : 5));
    const Rigid3 truth =
        T_first_world * VehicleAt(static_cast<double>(stamp) * 1e-9) * T_vehicle_first;
    EXPECT_LT(VehicleError(result.T_world_body, truth), 0.04) << k;
  }
}

// Of each radar: a stamp that was there is skipped, the same time at another radar is not.
TEST(SeveralRadars, StampsRepeatPerRadar) {
  Odometry odometry(MountedOptions());
  for (std::int64_t k = 0; k < 5; ++k) odometry.AddScan(ScanAt(k * 50'000'000, 1));
  EXPECT_EQ(odometry.AddScan(ScanAt(200'000'000, 2)).status, Status::kRegistered);
  EXPECT_EQ(odometry.AddScan(ScanAt(200'000'000, 2)).reason, "stamp repeats");
  EXPECT_EQ(odometry.AddScan(ScanAt(150'000'000, 2)).reason, "stamp goes back");
  EXPECT_EQ(odometry.AddScan(ScanAt(250'000'000, 1)).status, Status::kRegistered);
}

// One radar falls silent in the middle of the drive, another one sees nothing.
TEST(SeveralRadars, OneIsEnough) {
  Odometry odometry(MountedOptions());
  const Rigid3 T_first_world = VehicleAt(0.0).Inverse();
  for (int k = 0; k < 80; ++k) {
    const std::int64_t stamp = k * 20'000'000;
    const int radar = std::array<int, 3>{1, 2, 5}[static_cast<std::size_t>(k % 3)];
    if (k > 30 && radar == 1) continue;
    RadarScan scan = ScanAt(stamp, radar);
    if (k > 30 && radar == 5) scan.returns.clear();
    const OdometryResult result = odometry.AddScan(scan);
    const Rigid3 truth = T_first_world * VehicleAt(static_cast<double>(stamp) * 1e-9);
    EXPECT_LT(VehicleError(result.T_world_body, truth), 0.05) << k << " " << radar;
  }
}

}  // namespace
}  // namespace radive
