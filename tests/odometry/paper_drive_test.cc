// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Short drives with the paper's own configurations. RADIVE_CONFIGS is configs/, from CMake.

#include <gtest/gtest.h>

#include <iostream>
#include <string>

#include "radive/config/load_config.h"
#include "radive/geometry/spherical.h"
#include "radive/odometry/scan_filter.h"
#include "tests/simulated_drive.h"

namespace radive {
namespace {

using testing::Compare;
using testing::Drive;
using testing::DriveErrors;
using testing::RunOdometry;
using testing::Scenario;
using testing::SimulateDrive;

OdometryOptions PaperOptions(const std::string& sensor) {
  std::string error;
  const auto config =
      LoadRunConfig(std::string(RADIVE_CONFIGS) + "/paper_" + sensor + ".yaml", "", &error);
  EXPECT_TRUE(config) << error;
  return config ? config->odometry : OdometryOptions();
}

DriveErrors RunPaper(const std::string& sensor, int frames) {
  const Drive drive = SimulateDrive(Scenario("street_" + sensor, frames));
  const std::vector<OdometryResult> results = RunOdometry(PaperOptions(sensor), drive.scans);
  const DriveErrors errors = Compare(drive, results);
  int num_keyframes = 0;
  for (const OdometryResult& result : results) num_keyframes += result.is_keyframe ? 1 : 0;
  std::cout << errors.length << " m: rmse " << errors.rmse << " m, heading " << errors.max_rotation
            << " rad, " << errors.num_registered << " of " << frames << " registered, "
            << num_keyframes << " keyframes\n";
  // One after 2 m or 3 deg.
  EXPECT_GE(num_keyframes, 1 + static_cast<int>(errors.length / 4.0));
  return errors;
}

TEST(PaperDrive, Dense) {
  const DriveErrors errors = RunPaper("dense", 40);
  EXPECT_GT(errors.num_registered, 36);
  EXPECT_LT(errors.rmse, 0.1 * errors.length);
}

TEST(PaperDrive, Sparse) {
  // The learned surface of 150 returns per scan is coarse: 1.6 m on these 9.4 m.
  const DriveErrors errors = RunPaper("sparse", 100);
  EXPECT_LT(errors.rmse, 0.35 * errors.length);
}

// Twelve scans of a radar that stands: each is registered, none is held.
TEST(PaperDrive, IsRegisteredWhileStanding) {
  SimulationOptions simulation = Scenario("street_dense", 12);
  Drive drive = SimulateDrive(simulation);
  for (RadarScan& scan : drive.scans) {
    scan.returns = drive.scans[0].returns;
    for (RadarReturn& entry : scan.returns) entry.doppler = 0.0;
  }
  OdometryOptions options = PaperOptions("dense");
  for (const OdometryResult& result : RunOdometry(options, drive.scans)) {
    EXPECT_NE(result.status, OdometryResult::Status::kStanding);
  }
  options.ego_velocity.standing_speed = 0.05;
  EXPECT_EQ(RunOdometry(options, drive.scans).back().status, OdometryResult::Status::kStanding);
}

// Behind each return stands a second one: the velocity is fitted to what the bins leave.
TEST(ScanFilter, BinsComeBeforeTheVelocityWhenAskedTo) {
  RadarScan scan;
  scan.has_doppler = true;
  for (int i = 0; i < 60; ++i) {
    const double azimuth = -0.9 + 0.03 * i, elevation = 0.01 * (i % 7);
    RadarReturn entry;
    entry.position = FromSpherical({20.0, azimuth, elevation});
    entry.doppler = -entry.position.dot(Eigen::Vector3d(10.0, 0.0, 0.0)) / 20.0;
    scan.returns.push_back(entry);
    entry.position *= 2.0;
    scan.returns.push_back(entry);
  }
  OdometryOptions options = PaperOptions("dense");
  for (const bool is_first : {true, false}) {
    using Order = PreprocessingOptions::AzimuthBinOrder;
    options.preprocessing.azimuth_bin_order =
        is_first ? Order::kBeforeVelocity : Order::kAfterVelocity;
    ScanFilter filter(options, options.sensor);
    OdometryResult result;
    const FilteredScan filtered = filter.Filter(scan, &result);
    EXPECT_EQ(filtered.returns.size(), 60u) << "in either order the farther ones go";
    EXPECT_EQ(result.ego_velocity.num_returns, is_first ? 60 : 120);
  }
}

}  // namespace
}  // namespace radive
