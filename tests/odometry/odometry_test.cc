// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Scans that odometry cannot use as they are, and what it says of them.

#include "radive/odometry/odometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "radive/odometry/submap.h"
#include "radive/odometry/vehicle_model.h"
#include "tests/synthetic_scene.h"

namespace radive {
namespace {

using Status = OdometryResult::Status;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::int64_t kInterval = 50'000'000;  // [ns]

// A radar on the street of StreetPoints(); exact returns of what is ahead.
RadarScan StreetScan(int k, double x, double speed) {
  RadarScan scan;
  scan.stamp_ns = k * kInterval;
  scan.has_doppler = true;
  for (const Eigen::Vector3d& p : testing::StreetPoints()) {
    RadarReturn entry;
    entry.position = p - Eigen::Vector3d(x, 0.0, 1.0);
    if (entry.position.x() < 0.5 * std::abs(entry.position.y())) continue;
    entry.doppler = -speed * entry.position.normalized().x();
    scan.returns.push_back(entry);
  }
  return scan;
}

// It drives at constant velocity along x, and starts 30 m before the origin.
struct StreetDrive {
  double speed = 5.0;  // [m/s]

  Eigen::Vector3d PositionAt(int k) const {
    return {speed * static_cast<double>(k * kInterval) * 1e-9, 0.0, 0.0};
  }
  RadarScan ScanAt(int k) const { return StreetScan(k, PositionAt(k).x() - 30.0, speed); }
};

double Error(const OdometryResult& result, const Eigen::Vector3d& position) {
  return (result.T_world_radar.translation - position).norm() +
         RotationVector(result.T_world_radar.rotation).norm();
}

OdometryOptions Options() {
  OdometryOptions options;
  options.registration.planar = true;
  options.ndt.representation = NdtOptions::Representation::kPoint;
  return options;
}

// Each return `count` times, a few centimetres apart, as an imaging radar sees it.
RadarScan Dense(const RadarScan& scan, int count) {
  RadarScan dense = scan;
  dense.returns.clear();
  for (const RadarReturn& entry : scan.returns) {
    for (int i = 0; i < count; ++i) {
      dense.returns.push_back(entry);
      dense.returns.back().position *= 1.0 + 0.001 * i;  // along the ray: the same Doppler
    }
  }
  return dense;
}

bool SamePoses(const OdometryResult& a, const OdometryResult& b) {
  return a.T_world_radar.translation == b.T_world_radar.translation &&
         a.T_world_radar.rotation.coeffs() == b.T_world_radar.rotation.coeffs() &&
         a.num_gaussians == b.num_gaussians;
}

TEST(Odometry, FollowsAnExactDrive) {
  const StreetDrive drive;
  Odometry odometry(Options());
  for (int k = 0; k < 60; ++k) {
    const OdometryResult result = odometry.AddScan(drive.ScanAt(k));
    EXPECT_EQ(result.status, Status::kRegistered) << result.reason;
    EXPECT_EQ(result.reason, "");
    EXPECT_EQ(result.index, k);
    EXPECT_EQ(result.stamp_ns, k * kInterval);
    EXPECT_LT(Error(result, drive.PositionAt(k)), 0.03);
    EXPECT_TRUE(result.covariance.allFinite());
    EXPECT_EQ(result.keyframe_points.empty(), !result.is_keyframe);
    if (k > 0) {
      EXPECT_GT(result.covariance(3, 3), 0.0);
      EXPECT_GT(result.num_pairs, 50);
    }
    EXPECT_NEAR(result.ego_velocity.v_radar.x(), 5.0, 1e-3);
  }
  EXPECT_TRUE(odometry.TakeNotes().empty());
}

// In the middle of a drive: no scan may break the pose, and the drive goes on behind it.
TEST(Odometry, PassesOverScansWithTooFewReturns) {
  const StreetDrive drive;
  for (const std::size_t count : {0u, 1u, 5u}) {
    Odometry odometry(Options());
    for (int k = 0; k < 40; ++k) {
      RadarScan scan = drive.ScanAt(k);
      const bool is_thin = k >= 20 && k < 23;
      if (is_thin) scan.returns.resize(count);
      const OdometryResult result = odometry.AddScan(scan);
      EXPECT_EQ(result.status, is_thin ? Status::kPredicted : Status::kRegistered) << k;
      EXPECT_EQ(result.reason.empty(), !is_thin) << result.reason;
      EXPECT_LT(Error(result, drive.PositionAt(k)), 0.1) << k << ", " << count << " returns";
      if (is_thin) {
        EXPECT_FALSE(result.is_keyframe);
        EXPECT_EQ(result.num_returns, static_cast<int>(count));
      }
    }
  }
}

// Positions in centimetres: all returns are beyond the largest range.
TEST(Odometry, SaysWhereTheReturnsWent) {
  RadarScan scan = StreetDrive().ScanAt(0);
  for (RadarReturn& ret : scan.returns) ret.position *= 100.0;
  Odometry odometry(Options());
  const std::string reason = odometry.AddScan(scan).reason;
  const std::string count = std::to_string(scan.returns.size());
  EXPECT_NE(reason.find("of " + count + " returns " + count + " are outside "), std::string::npos)
      << reason;
}

// From the very first scan on: nothing to start from, no pose but the origin.
TEST(Odometry, StartsWithTheFirstScanThatHasReturns) {
  const StreetDrive drive;
  Odometry odometry(Options());
  for (int k = 0; k < 3; ++k) {
    RadarScan scan = drive.ScanAt(k);
    scan.returns.clear();
    const OdometryResult result = odometry.AddScan(scan);
    EXPECT_EQ(result.status, Status::kPredicted);
    EXPECT_NE(result.reason, "");
    EXPECT_LT(Error(result, Eigen::Vector3d::Zero()), 1e-12);
  }
  for (int k = 3; k < 20; ++k) {
    const OdometryResult result = odometry.AddScan(drive.ScanAt(k));
    EXPECT_EQ(result.status, Status::kRegistered) << result.reason;
    // The first velocity is known with scan 3: its own interval is predicted, no earlier one.
    EXPECT_LT(Error(result, drive.PositionAt(k) - drive.PositionAt(2)), 0.03);
  }
}

TEST(Odometry, AllEmptyDrive) {
  Odometry odometry(Options());
  for (int k = 0; k < 10; ++k) {
    RadarScan scan;
    scan.stamp_ns = k * kInterval;
    scan.has_doppler = true;
    const OdometryResult result = odometry.AddScan(scan);
    EXPECT_EQ(result.status, Status::kPredicted);
    EXPECT_FALSE(result.is_keyframe);
  }
}

TEST(Odometry, DropsReturnsThatAreNotFinite) {
  const StreetDrive drive;
  Odometry clean(Options()), dirty(Options());
  for (int k = 0; k < 20; ++k) {
    const RadarScan scan = drive.ScanAt(k);
    RadarScan with_nan = scan;
    RadarReturn bad = scan.returns[0];
    bad.position.y() = kNaN;
    with_nan.returns.insert(with_nan.returns.begin() + 3, bad);
    bad.position = {std::numeric_limits<double>::infinity(), 0.0, 0.0};
    with_nan.returns.push_back(bad);
    bad.position = {5.0, 5.0, 0.0};
    bad.doppler = kNaN;
    with_nan.returns.push_back(bad);
    const OdometryResult expected = clean.AddScan(scan);
    const OdometryResult actual = dirty.AddScan(with_nan);
    EXPECT_EQ(ToPoseBlock(actual.T_world_radar), ToPoseBlock(expected.T_world_radar));
    EXPECT_EQ(actual.num_returns, expected.num_returns + 3);
    EXPECT_EQ(actual.num_kept, expected.num_kept);
  }
  // Nothing but such returns is an empty scan.
  RadarScan scan = drive.ScanAt(20);
  for (RadarReturn& entry : scan.returns) entry.position.setConstant(kNaN);
  const OdometryResult result = dirty.AddScan(scan);
  EXPECT_EQ(result.status, Status::kPredicted);
  EXPECT_LT(Error(result, drive.PositionAt(20)), 0.1);
}

TEST(Odometry, SkipsStampsThatRepeatOrGoBack) {
  const StreetDrive drive;
  Odometry odometry(Options());
  OdometryResult last;
  for (int k = 0; k < 10; ++k) last = odometry.AddScan(drive.ScanAt(k));
  OdometryResult result = odometry.AddScan(drive.ScanAt(9));
  EXPECT_EQ(result.status, Status::kSkipped);
  EXPECT_EQ(result.reason, "stamp repeats");
  EXPECT_EQ(ToPoseBlock(result.T_world_radar), ToPoseBlock(last.T_world_radar));
  result = odometry.AddScan(drive.ScanAt(4));
  EXPECT_EQ(result.status, Status::kSkipped);
  EXPECT_EQ(result.reason, "stamp goes back");
  EXPECT_EQ(result.index, 11);
  // The drive goes on where it was.
  result = odometry.AddScan(drive.ScanAt(10));
  EXPECT_EQ(result.status, Status::kRegistered);
  EXPECT_LT(Error(result, drive.PositionAt(10)), 0.03);
}

// A bus fills the view for 0.4 s and drives along: its returns give a velocity that the temporal
// gate refuses, and the pose goes on as it was.
TEST(Odometry, IsNotTakenAlongByTraffic) {
  const StreetDrive drive;
  Odometry odometry(Options());
  for (int k = 0; k < 60; ++k) {
    RadarScan scan = drive.ScanAt(k);
    const bool is_blocked = k >= 20 && k < 28;
    if (is_blocked) {
      // The same places, seen from a radar that stands still relative to them.
      scan.returns = drive.ScanAt(20).returns;
      for (RadarReturn& entry : scan.returns) entry.doppler = 0.0;
    }
    const OdometryResult result = odometry.AddScan(scan);
    if (is_blocked) {
      EXPECT_EQ(result.status, Status::kPredicted) << k;
      EXPECT_NE(result.reason.find("ego velocity"), std::string::npos) << result.reason;
      EXPECT_EQ(result.num_kept, 0) << "no moving return may enter the map";
      EXPECT_EQ(result.dropped.moving, result.num_returns);
    }
    EXPECT_LT(Error(result, drive.PositionAt(k)), 0.15) << k;
  }
}

// Half of the returns move with other velocities than the street's.
TEST(Odometry, LeavesMovingReturnsOut) {
  const StreetDrive drive;
  Odometry odometry(Options());
  for (int k = 0; k < 40; ++k) {
    RadarScan scan = drive.ScanAt(k);
    const std::size_t num_static = scan.returns.size();
    for (std::size_t i = 0; i < num_static; i += 2) {
      RadarReturn moving = scan.returns[i];
      moving.position *= 0.8;
      moving.doppler += 3.0 + 0.1 * static_cast<double>(i % 40);
      scan.returns.push_back(moving);
    }
    const OdometryResult result = odometry.AddScan(scan);
    EXPECT_EQ(result.num_kept, static_cast<int>(num_static));
    EXPECT_EQ(result.dropped.moving, static_cast<int>((num_static + 1) / 2));
    EXPECT_EQ(result.dropped.Sum(), result.dropped.moving);
    EXPECT_LT(Error(result, drive.PositionAt(k)), 0.03) << k;
  }
}

// Brakes at 4 m/s^2, stands for five seconds, moves off. Standing, the pose must not move by a
// hair, whatever the noise.
TEST(Odometry, StandsStill) {
  Odometry odometry(Options());
  Random random(1);
  double x = -30.0, speed = 5.0;
  int num_standing = 0;
  Rigid3 T_stop;
  for (int k = 0; k < 220; ++k) {
    RadarScan scan = StreetScan(k, x, speed);
    const bool stands = speed == 0.0;
    for (RadarReturn& entry : scan.returns) {
      entry.doppler += 0.05 * random.Normal();
      if (stands) entry.position += 0.1 * testing::RandomNormal3(&random);
    }
    const OdometryResult result = odometry.AddScan(scan);
    EXPECT_LT(Error(result, {x + 30.0, 0.0, 0.0}), 0.15) << k;
    if (result.status == Status::kStanding) {
      if (num_standing++ == 0) T_stop = result.T_world_radar;
      EXPECT_TRUE(result.ego_velocity.is_standing);
      EXPECT_EQ(result.reason, "standing");
      EXPECT_FALSE(result.is_keyframe);
      EXPECT_EQ(ToPoseBlock(result.T_world_radar), ToPoseBlock(T_stop)) << k;
    } else {
      EXPECT_EQ(result.status, Status::kRegistered) << k << " " << result.reason;
    }
    // Speed of the next scan.
    const double next =
        k < 20 || k >= 150 ? std::min(5.0, speed + 0.2) : std::max(0.0, speed - 0.2);
    x += 0.5 * (speed + next) * static_cast<double>(kInterval) * 1e-9;
    speed = next;
  }
  // 105 scans stand: braking takes 25 of the 130.
  EXPECT_GE(num_standing, 95);
  EXPECT_LE(num_standing, 108);
}

// The radar comes to a halt while no scan arrives: the pose from before must not be kept.
TEST(Odometry, SeesThatItStoppedElsewhere) {
  Odometry odometry(Options());
  const StreetDrive drive;
  for (int k = 0; k < 20; ++k) odometry.AddScan(drive.ScanAt(k));
  // Braked at 5 m/s^2 within the second: 2.5 m.
  const double stop = drive.PositionAt(19).x() + 2.5;
  for (int k = 39; k < 45; ++k) {
    const OdometryResult result = odometry.AddScan(StreetScan(k, stop - 30.0, 0.0));
    EXPECT_EQ(result.status, k == 39 ? Status::kRegistered : Status::kStanding) << result.reason;
    EXPECT_LT(Error(result, {stop, 0.0, 0.0}), 0.1) << k;
  }
}

// From one scan to the next all that is seen lies 15 m higher, as where a road leaves a cutting:
// nothing of the submap is found any more. After restart_time the submap goes on where the Doppler
// says the radar is.
TEST(Odometry, GoesOnWhereItsSubmapEnds) {
  const StreetDrive drive;
  OdometryOptions options = Options();
  options.motion.restart_time = 0.97;
  Odometry odometry(options);
  // 20 scans of 0.05 s.
  constexpr int kChange = 20, kRestart = 39;
  for (int k = 0; k < kRestart + 20; ++k) {
    RadarScan scan = drive.ScanAt(k);
    for (RadarReturn& entry : scan.returns) {
      if (k >= kChange) entry.position.z() += 15.0;
      entry.doppler = -drive.speed * entry.position.normalized().x();
    }
    const OdometryResult result = odometry.AddScan(scan);
    const bool is_lost = k >= kChange && k <= kRestart;
    EXPECT_EQ(result.status, is_lost ? Status::kPredicted : Status::kRegistered) << k;
    if (is_lost) {
      EXPECT_EQ(result.is_keyframe, k == kRestart) << k;
    }
    EXPECT_LT(Error(result, drive.PositionAt(k)), 0.05) << k;
  }
}

// What the options leave open is chosen by the first scan and said once; the drive is then the same
// as with that choice made by hand.
TEST(Odometry, ChoosesTheGaussiansThatSuitTheScans) {
  const StreetDrive drive;
  for (const bool is_dense : {false, true}) {
    OdometryOptions options = Options();
    options.ndt.representation =
        is_dense ? NdtOptions::Representation::kVoxel : NdtOptions::Representation::kPoint;
    Odometry set(options);
    options.ndt.representation = NdtOptions::Representation::kAuto;
    Odometry automatic(options);
    for (int k = 0; k < 10; ++k) {
      RadarScan scan = drive.ScanAt(k);
      if (!is_dense) scan.returns.resize(300);
      if (is_dense) scan = Dense(scan, 8);
      if (k == 0) scan.returns.resize(5);  // too few to start, and so to choose
      const OdometryResult result = automatic.AddScan(scan);
      EXPECT_TRUE(SamePoses(result, set.AddScan(scan))) << is_dense << " " << k;
      EXPECT_EQ(result.status == Status::kRegistered, k > 0);
    }
    EXPECT_TRUE(set.TakeNotes().empty());
    const std::vector<std::string> notes = automatic.TakeNotes();
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].find(is_dense ? "ndt.representation voxel, for the first scan has"
                                     : "ndt.representation point, for the first scan has 300"),
              0u)
        << notes[0];
  }
}

// With ego velocity off the Doppler is not looked at, and the run says so.
TEST(Odometry, EgoVelocityCanBeSwitchedOff) {
  const StreetDrive drive;
  OdometryOptions options = Options();
  options.ego_velocity.enabled = false;
  Odometry odometry(options);
  for (int k = 0; k < 40; ++k) {
    const OdometryResult result = odometry.AddScan(drive.ScanAt(k));
    EXPECT_FALSE(result.ego_velocity.valid);
    EXPECT_LT(Error(result, drive.PositionAt(k)), 0.1) << k;
  }
  const std::vector<std::string> notes = odometry.TakeNotes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("switched off"), std::string::npos);
}

// 4 m from scan to scan and no Doppler: too far for a start from rest.
TEST(Odometry, StartsWithTheMotionItIsTold) {
  const StreetDrive drive{80.0};
  for (const bool is_told : {false, true}) {
    Odometry odometry(Options());
    if (is_told) odometry.StartMotion(0, {80.5, 0.2, 0.0});
    double error = 0.0;
    for (int k = 0; k < 6; ++k) {
      RadarScan scan = drive.ScanAt(k);
      scan.has_doppler = false;
      error = std::max(error, Error(odometry.AddScan(scan), drive.PositionAt(k)));
      // Once it moves it goes by what it has seen.
      odometry.StartMotion(0, {is_told ? -80.0 : 0.0, 0.0, 0.0});
      if (k == 0 && is_told) odometry.StartMotion(0, {80.5, 0.2, 0.0});
    }
    if (is_told) {
      EXPECT_LT(error, 0.1);
    } else {
      EXPECT_GT(error, 4.0);
    }
  }
}

TEST(Odometry, StatusWords) {
  EXPECT_STREQ(ToString(Status::kRegistered), "registered");
  EXPECT_STREQ(ToString(Status::kPredicted), "predicted");
  EXPECT_STREQ(ToString(Status::kStanding), "standing");
  EXPECT_STREQ(ToString(Status::kSkipped), "skipped");
}

TEST(Odometry, RefusesInvalidOptions) {
  OdometryOptions options;
  options.pairs.d_max = -1.0;
  std::string error;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("pairs.d_max must be > 0"), std::string::npos) << error;
  EXPECT_DEATH(Odometry{options}, "d_max");
}

MotionOptions RoadVehicle() {
  MotionOptions options;
  options.no_slip = true;
  options.slip_compliance = 0.003;
  return options;
}

// At 10 m/s the point without slip lies 0.3 m ahead of the rear axle: closer to a radar at the
// front, farther from one at the rear, and never more than half-way.
TEST(VehicleModel, PointWithoutSlipMovesAhead) {
  for (const auto& [mount, lever] :
       std::vector<std::pair<double, double>>{{3.6, 3.3}, {-0.9, -1.2}, {0.4, 0.2}, {0.0, 0.0}}) {
    const Rigid3 T_vehicle_radar = {Eigen::Quaterniond::Identity(), {mount, 0.5, 1.0}};
    const VehicleModel vehicle(RoadVehicle());
    const auto prior = vehicle.Prior(T_vehicle_radar, Rigid3(), {10.0, 0.0, 0.0}, 0.1);
    ASSERT_TRUE(prior);
    EXPECT_NEAR(prior->T_e_radar.translation.x(), lever, 1e-12);
    EXPECT_EQ(prior->T_e_radar.translation.y(), 0.5);
    EXPECT_EQ(prior->lateral_offset, 0.0);
    // 1.65 m/s to the left 3.3 m ahead of what does not slip: half a radian per second.
    const auto yaw_rate = vehicle.YawRate(T_vehicle_radar, {10.0, 1.65, 0.0});
    EXPECT_EQ(yaw_rate.has_value(), mount > 1.0);
    if (yaw_rate) {
      EXPECT_NEAR(*yaw_rate, 0.5, 1e-12);
    }
  }
  const VehicleModel off{MotionOptions()};
  EXPECT_FALSE(off.Prior(Rigid3(), Rigid3(), {10.0, 0.0, 0.0}, 0.1));
  EXPECT_FALSE(off.YawRate(Rigid3(), {10.0, 0.0, 0.0}));
}

// A car that always slides 2 mrad to the left leaves 2 mm of each metre in the residual; the slip
// angle is found but for what the process lets fade, and the prior expects it from then on.
TEST(VehicleModel, FollowsAConstantSlipAngle) {
  constexpr double kSlip = 0.002, kStep = 1.0, kInterval_s = 0.1;
  const Rigid3 T_vehicle_radar = {Eigen::Quaterniond::Identity(), {3.6, 0.0, 0.0}};
  VehicleModel vehicle(RoadVehicle());
  const Eigen::Vector3d v(kStep / kInterval_s, 0.0, 0.0);
  for (int k = 0; k < 300; ++k) {
    vehicle.Advance(kInterval_s);
    const double expected =
        vehicle.Prior(T_vehicle_radar, Rigid3(), v, kInterval_s)->lateral_offset;
    // Registration sees the displacement to 5 mm, and believes it rather than the prior.
    vehicle.Update(T_vehicle_radar, v, kInterval_s, kSlip * kStep - expected, 2.5e-5);
  }
  EXPECT_GT(vehicle.slip(), 0.5 * kSlip);
  EXPECT_LT(vehicle.slip(), kSlip);
  EXPECT_NEAR(vehicle.Prior(T_vehicle_radar, Rigid3(), v, kInterval_s)->lateral_offset,
              vehicle.slip() * kStep,
              1e-12);
  // Left alone, it fades.
  vehicle.Advance(100.0);
  EXPECT_LT(std::abs(vehicle.slip()), 1e-6);
}

Keyframe MakeKeyframe(double x, int num_returns) {
  Keyframe keyframe;
  keyframe.T_world_radar = {QuaternionFromRotationVector({0.0, 0.0, 1.5707963267948966}),
                            {x, 0.0, 0.0}};
  for (int i = 0; i < num_returns; ++i) {
    RadarReturn entry;
    entry.position = {10.0 + i, 0.0, 0.0};
    keyframe.returns.push_back(entry);
    keyframe.weights.push_back(0.5);
  }
  return keyframe;
}

// Turned 90 degrees to the left: a return 10 m ahead of the radar lies at y = 10, and its noise is
// turned with it.
TEST(Submap, HoldsTheKeyframesOfItsWindowInTheWorldFrame) {
  SubmapOptions options;
  options.num_keyframes = 3;
  NdtOptions ndt;
  SensorOptions sensor;
  const std::unique_ptr<Submap> submap = MakeRawSubmap(options, ndt, sensor);
  EXPECT_EQ(submap->search(), nullptr);
  for (int k = 0; k < 5; ++k) {
    submap->AddKeyframe(MakeKeyframe(100.0 * k, 4));
    ASSERT_NE(submap->search(), nullptr);
    EXPECT_EQ(submap->search()->submap().size(), static_cast<std::size_t>(4 * std::min(k + 1, 3)));
  }
  const Gaussian3& oldest = submap->search()->submap()[0];
  EXPECT_LT((oldest.mean - Eigen::Vector3d(200.0, 10.0, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(oldest.covariance(1, 1), std::pow(sensor.sigma_range, 2) + ndt.epsilon, 1e-12);
  EXPECT_NEAR(
      oldest.covariance(0, 0), std::pow(10.0 * sensor.sigma_azimuth, 2) + ndt.epsilon, 1e-12);
  EXPECT_EQ(oldest.weight, 0.5);
  submap->Clear();
  EXPECT_EQ(submap->search(), nullptr);
}

TEST(Submap, VoxelsAreThoseOfAllKeyframesTogether) {
  NdtOptions ndt;
  ndt.representation = NdtOptions::Representation::kVoxel;
  const std::unique_ptr<Submap> submap = MakeRawSubmap(SubmapOptions(), ndt, SensorOptions());
  submap->AddKeyframe(MakeKeyframe(0.5, 4));  // y = 10, 11 | 12, 13 in voxels of 2 m
  EXPECT_EQ(submap->search()->submap().size(), 2u);
  submap->AddKeyframe(MakeKeyframe(1.0, 4));  // the same voxels
  ASSERT_EQ(submap->search()->submap().size(), 2u);
  EXPECT_EQ(submap->search()->submap()[0].count, 4);
  EXPECT_LT((submap->search()->submap()[0].mean - Eigen::Vector3d(0.75, 10.5, 0.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace radive
