// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "radive/geometry/rigid3.h"
#include "radive/odometry/odometry.h"
#include "radive/simulation/radar_simulator.h"

// Simulated drives for the tests of odometry.

namespace radive::testing {

struct Drive {
  std::vector<RadarScan> scans;
  std::vector<GroundTruth> truths;
  SimulationOptions simulation;
};

inline Drive SimulateDrive(const SimulationOptions& options) {
  Drive drive;
  drive.simulation = options;
  RadarSimulator simulator(options);
  RadarScan scan;
  GroundTruth truth;
  while (simulator.Next(&scan, &truth)) {
    drive.scans.push_back(scan);
    drive.truths.push_back(truth);
  }
  return drive;
}

inline SimulationOptions Scenario(const std::string& name, int frames) {
  SimulationOptions options = ScenarioOptions(name).value();
  options.frames = frames;
  return options;
}

// Settings for the simulated sensor: its noise and its mount, and the vehicle's plane.
inline OdometryOptions OptionsFor(const SimulationOptions& simulation) {
  OdometryOptions options;
  const SensorModel model = simulation.Sensor();
  options.sensor.sigma_range = model.sigma_range;
  options.sensor.sigma_azimuth = model.sigma_azimuth;
  if (model.sigma_elevation > 0.0) options.sensor.sigma_elevation = model.sigma_elevation;
  options.sensor.sigma_doppler = model.sigma_doppler;
  options.sensor.mount_x = simulation.mount_position[0];
  options.sensor.mount_y = simulation.mount_position[1];
  options.sensor.mount_z = simulation.mount_position[2];
  options.sensor.mount_yaw = simulation.mount_yaw;
  options.registration.planar = true;
  options.motion.no_slip = true;
  options.motion.slip_compliance = 0.0;  // the simulated rear axle does not drift
  options.ndt.representation = NdtOptions::Representation::kPoint;
  if (simulation.sensor == SensorType::kOculii) {
    options.ndt.representation = NdtOptions::Representation::kVoxel;
    options.submap.num_keyframes = 15;
  }
  return options;
}

inline std::vector<OdometryResult> RunOdometry(const OdometryOptions& options,
                                               const std::vector<RadarScan>& scans) {
  Odometry odometry(options);
  std::vector<OdometryResult> results;
  for (const RadarScan& scan : scans) results.push_back(odometry.AddScan(scan));
  return results;
}

// Pose of scan i relative to the first, as it truly is.
inline Rigid3 TruePose(const Drive& drive, std::size_t i) {
  return drive.truths[0].T_world_radar.Inverse() * drive.truths[i].T_world_radar;
}

struct DriveErrors {
  double length = 0.0;        // of the drive [m]
  double rmse = 0.0;          // of the positions, first poses aligned, in the plane [m]
  double end = 0.0;           // of the last position, in the plane [m]
  double max_rotation = 0.0;  // largest error of the heading [rad]
  int num_registered = 0;
};

inline DriveErrors Compare(const Drive& drive, const std::vector<OdometryResult>& results) {
  DriveErrors errors;
  EXPECT_EQ(drive.scans.size(), results.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Rigid3 truth = TruePose(drive, i);
    const double error =
        (results[i].T_world_radar.translation - truth.translation).head<2>().norm();
    sum += error * error;
    errors.end = error;
    if (i > 0) {
      errors.length += (truth.translation - TruePose(drive, i - 1).translation).norm();
    }
    const Eigen::Vector3d turned =
        RotationVector(results[i].T_world_radar.rotation * truth.rotation.conjugate());
    errors.max_rotation = std::max(errors.max_rotation, std::abs(turned.z()));
    if (results[i].status == OdometryResult::Status::kRegistered) ++errors.num_registered;
  }
  errors.rmse = std::sqrt(sum / static_cast<double>(results.size()));
  return errors;
}

}  // namespace radive::testing
