// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The ego velocity on real drives, against velocities that were checked when the data were taken
// in.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "radive/ego_velocity/ego_velocity_estimator.h"
#include "radive/io/open/open_scan_source.h"
#include "radive/preprocessing/preprocess.h"
#include "tests/shared_data.h"

namespace radive {
namespace {

struct Drive {
  std::vector<EgoVelocity> velocities;  // one a scan
  std::vector<std::int64_t> stamps_ns;

  int NumValid() const {
    int count = 0;
    for (const EgoVelocity& velocity : velocities) count += velocity.valid ? 1 : 0;
    return count;
  }
};

Drive EstimateDrive(const std::string& relative,
                    const InputOptions& input,
                    const PreprocessingOptions& preprocessing,
                    const EgoVelocityOptions& options) {
  Drive drive;
  std::string error;
  const auto source = OpenScanSource((testing::SharedData() / relative).string(), input, &error);
  if (source == nullptr) {
    ADD_FAILURE() << error;
    return drive;
  }
  EgoVelocityEstimator estimator(options, SensorOptions());
  RadarScan scan;
  while (source->Next(&scan) == ScanSource::Status::kScan) {
    const auto returns = Preprocess(scan, SensorOptions(), preprocessing, nullptr);
    drive.velocities.push_back(estimator.Estimate(returns, scan.is_planar, scan.stamp_ns));
    drive.stamps_ns.push_back(scan.stamp_ns);
  }
  return drive;
}

TEST(RealEgoVelocity, ViewOfDelft) {
  RADIVE_SKIP_WITHOUT("vod-example-frames");
  InputOptions input;
  input.layout = "vod7";
  EgoVelocityOptions options;
  options.fit_gate = 0.2;
  options.vertical_ridge = 0.0;  // the checked velocities are plain least squares
  options.temporal_gate = 0.0;   // the frames are not consecutive
  const Drive drive = EstimateDrive("vod-example-frames", input, PreprocessingOptions(), options);
  ASSERT_EQ(drive.velocities.size(), 3u);
  const Eigen::Vector3d expected[] = {
      {1.92, 0.02, -0.02}, {2.94, -0.54, -0.06}, {2.61, 0.14, 0.13}};
  for (std::size_t k = 0; k < 3; ++k) {
    const EgoVelocity& velocity = drive.velocities[k];
    EXPECT_TRUE(velocity.valid) << velocity.reason;
    EXPECT_LT((velocity.v_radar - expected[k]).norm(), 0.03) << velocity.v_radar.transpose();
    const double share = velocity.num_inliers / static_cast<double>(velocity.num_returns);
    EXPECT_GT(share, 0.75);
    EXPECT_LT(share, 0.82);
    EXPECT_GT(velocity.residual_rms, 0.02);
    EXPECT_LT(velocity.residual_rms, 0.045);
  }
}

TEST(RealEgoVelocity, MscRad4r) {
  RADIVE_SKIP_WITHOUT("mscrad4r-urban-c0");
  InputOptions input;
  input.layout = "xyzdp5";
  input.rate = 15.0;
  PreprocessingOptions preprocessing;
  preprocessing.min_range = 3.0;
  preprocessing.max_range = 400.0;
  preprocessing.max_azimuth = 0.986;  // +-56.5 deg and +-22.5 deg: what the sensor can see
  preprocessing.min_azimuth = -0.986;
  preprocessing.max_elevation = 0.393;
  preprocessing.min_elevation = -0.393;
  const Drive drive =
      EstimateDrive("mscrad4r-urban-c0", input, preprocessing, EgoVelocityOptions());
  ASSERT_EQ(drive.velocities.size(), 310u);
  EXPECT_EQ(drive.NumValid(), 310);
  EXPECT_TRUE(drive.velocities[0].is_standing);
  for (const auto& [k, speed] : {std::pair(0, 0.0), std::pair(60, 4.86), std::pair(300, 11.89)}) {
    EXPECT_NEAR(drive.velocities[static_cast<std::size_t>(k)].v_radar.x(), speed, 0.05) << k;
  }
  // A near-straight road, without jumps. Around scan 125 fits of other gates and with free v_z find
  // a v_y of 0.4 m/s as well.
  for (std::size_t k = 1; k < 310; ++k) {
    const Eigen::Vector3d& v_radar = drive.velocities[k].v_radar;
    EXPECT_GT(v_radar.y(), -0.25) << k;
    EXPECT_LT(v_radar.y(), 0.45) << k;
    EXPECT_LT(std::abs(v_radar.x() - drive.velocities[k - 1].v_radar.x()), 0.45) << k;
  }
}

TEST(RealEgoVelocity, Tj4dRadSet) {
  RADIVE_SKIP_WITHOUT("tj4dradset-sample");
  InputOptions input;
  input.layout = "tj4d8";
  const Drive drive =
      EstimateDrive("tj4dradset-sample", input, PreprocessingOptions(), EgoVelocityOptions());
  ASSERT_EQ(drive.velocities.size(), 41u);
  EXPECT_EQ(drive.NumValid(), 41);
  for (const EgoVelocity& velocity : drive.velocities) {
    EXPECT_GT(velocity.v_radar.x(), 16.9);
    EXPECT_LT(velocity.v_radar.x(), 17.8);
    EXPECT_GT(velocity.num_inliers, 0.8 * velocity.num_returns);
  }
  EXPECT_NEAR(drive.velocities.front().v_radar.x(), 16.98, 0.05);
  EXPECT_NEAR(drive.velocities.back().v_radar.x(), 17.50, 0.05);
}

// A line of radarK_scans.csv: speed of the rear axle and yaw rate of the car.
struct CarMotion {
  double time = 0.0;      // [s]
  double v_x = 0.0;       // [m/s]
  double yaw_rate = 0.0;  // [rad/s]
};

std::vector<CarMotion> ReadCarMotion(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<CarMotion> motions;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::vector<double> row;
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    if (row.size() == 10) motions.push_back({row[4], row[8], row[9]});
  }
  return motions;
}

// Radar 2 sits at (3.86, -0.7) m, turned by -0.436185662 rad, so that it moves with
// R' (v_x - w y_m, w x_m) when the car drives v_x and turns with w.
TEST(RealEgoVelocity, RadarScenes) {
  RADIVE_SKIP_WITHOUT("radarscenes");
  InputOptions input;
  input.format = InputOptions::Format::kRadarScenes;
  input.radar = "2";
  const Drive drive =
      EstimateDrive("radarscenes/seq105", input, PreprocessingOptions(), EgoVelocityOptions());
  const std::vector<CarMotion> motions =
      ReadCarMotion(testing::SharedData() / "radarscenes/seq105/radar2_scans.csv");
  ASSERT_EQ(drive.velocities.size(), 1606u);
  ASSERT_EQ(motions.size(), 1606u);
  EXPECT_EQ(drive.NumValid(), 1606);
  const Eigen::Matrix2d R_radar_car = Eigen::Rotation2Dd(0.436185662).toRotationMatrix();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero(), squares = Eigen::Vector2d::Zero();
  double worst = 0.0;
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const CarMotion& car = motions[k];
    const Eigen::Vector2d expected =
        R_radar_car * Eigen::Vector2d(car.v_x + 0.7 * car.yaw_rate, 3.86 * car.yaw_rate);
    const Eigen::Vector2d error = drive.velocities[k].v_radar.head<2>() - expected;
    sum += error;
    squares += error.cwiseAbs2();
    worst = std::max(worst, error.norm());
    EXPECT_EQ(drive.velocities[k].v_radar.z(), 0.0);
  }
  const double count = static_cast<double>(motions.size());
  // Known of this radar: 0.26 % slow, and 0.09 m/s of scatter between Doppler and odometry.
  EXPECT_LT((sum / count).norm(), 0.08) << (sum / count).transpose();
  EXPECT_LT(std::sqrt(squares.sum() / count), 0.16) << (squares / count).cwiseSqrt().transpose();
  EXPECT_LT(worst, 0.8);
}

}  // namespace
}  // namespace radive
