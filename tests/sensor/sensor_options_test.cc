// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/sensor/sensor_options.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <string>

#include "radive/sensor/measurement_correction.h"
#include "radive/sensor/radar_noise_model.h"
#include "radive/util/angle_units.h"

namespace radive {
namespace {

TEST(SensorOptions, MountTurnsRollThenPitchThenYaw) {
  SensorOptions sensor;
  sensor.mount_x = 3.86;
  sensor.mount_y = -0.7;
  sensor.mount_z = 0.5;
  sensor.mount_yaw = kPi / 2.0;  // looks to the left
  const Eigen::Vector3d ahead = sensor.T_vehicle_radar() * Eigen::Vector3d(10.0, 0.0, 0.0);
  EXPECT_LT((ahead - Eigen::Vector3d(3.86, 9.3, 0.5)).norm(), 1e-12);

  sensor.mount_pitch = kPi / 2.0;  // looks down: yaw then turns about the line of sight
  const Eigen::Vector3d down = sensor.T_vehicle_radar().rotation * Eigen::Vector3d::UnitX();
  EXPECT_LT((down - Eigen::Vector3d(0.0, 0.0, -1.0)).norm(), 1e-12);
  const Eigen::Vector3d top = sensor.T_vehicle_radar().rotation * Eigen::Vector3d::UnitZ();
  EXPECT_LT((top - Eigen::Vector3d(0.0, 1.0, 0.0)).norm(), 1e-12);

  sensor.mount_roll = kPi / 2.0;  // what was left of the radar now points up in it
  const Eigen::Vector3d left = sensor.T_vehicle_radar().rotation * Eigen::Vector3d::UnitY();
  EXPECT_LT((left - Eigen::Vector3d(0.0, 1.0, 0.0)).norm(), 1e-12);
}

TEST(SensorOptions, NamesTheFieldThatIsOutOfRange) {
  std::string error;
  SensorOptions sensor;
  EXPECT_TRUE(sensor.IsValid(&error)) << error;
  sensor.sigma_doppler = 0.0;
  EXPECT_FALSE(sensor.IsValid(&error));
  EXPECT_EQ(error, "sensor.sigma_doppler must be > 0 m/s, is 0");
  sensor = SensorOptions();
  sensor.azimuth_scale = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(sensor.IsValid(&error));
  EXPECT_NE(error.find("sensor.azimuth_scale"), std::string::npos);
}

TEST(CorrectPosition, KeepsTheVeryNumbersWhenNothingIsSet) {
  const Eigen::Vector3d p(1.1, -2.3, 0.7);
  EXPECT_EQ(CorrectPosition(p, SensorOptions()), p);
}

// A return at 30 degrees to the left, 10 m away: -0.04 of the azimuth and 1 degree more make
// 29.8 degrees, 1 % more range makes 10.1 m.
TEST(CorrectPosition, ScalesRangeAndAzimuthAndAddsTheOffset) {
  SensorOptions sensor;
  sensor.azimuth_scale = 0.96;
  sensor.azimuth_offset = kPi / 180.0;
  sensor.range_scale = 1.01;
  const double degree = kPi / 180.0;
  const double elevation = 10.0 * degree;
  const Eigen::Vector3d p = FromSpherical({10.0, 30.0 * degree, elevation});
  const Spherical corrected = ToSpherical(CorrectPosition(p, sensor));
  EXPECT_NEAR(corrected.range, 10.1, 1e-12);
  EXPECT_NEAR(corrected.azimuth, 29.8 * degree, 1e-12);
  EXPECT_NEAR(corrected.elevation, elevation, 1e-12);
  // Planar returns stay planar, to the last bit.
  EXPECT_EQ(CorrectPosition({3.0, 4.0, 0.0}, sensor).z(), 0.0);
}

TEST(PositionCovariance, IsDiagonalStraightAhead) {
  SensorOptions sensor;
  sensor.sigma_range = 0.1;
  sensor.sigma_azimuth = 0.02;
  sensor.sigma_elevation = 0.03;
  const Eigen::Matrix3d covariance = PositionCovariance({10.0, 0.0, 0.0}, sensor);
  const Eigen::Matrix3d expected = Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal();
  EXPECT_LT((covariance - expected).norm(), 1e-12);
  const Eigen::Matrix3d planar = PositionCovariance({10.0, 0.0, 0.0}, sensor, /*is_planar=*/true);
  const Eigen::Matrix3d expected_planar = Eigen::Vector3d(0.01, 0.04, 0.01).asDiagonal();
  EXPECT_LT((planar - expected_planar).norm(), 1e-12);
  const Eigen::Matrix3d left = PositionCovariance({0.0, 10.0, 0.0}, sensor);
  const Eigen::Matrix3d expected_left = Eigen::Vector3d(0.04, 0.01, 0.09).asDiagonal();
  EXPECT_LT((left - expected_left).norm(), 1e-12);
}

// To first order the covariance is J diag(variances) J' with the Jacobian of FromSpherical, taken
// numerically here.
TEST(PositionCovariance, IsTheNoisePropagatedThroughSphericalCoordinates) {
  const SensorOptions sensor;
  const Spherical s{20.0, -0.8, 0.3};
  Eigen::Matrix3d jacobian;
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i) {
    Eigen::Vector3d step = Eigen::Vector3d::Zero();
    step[i] = h;
    const auto at = [&](double sign) {
      return FromSpherical(
          {s.range + sign * step[0], s.azimuth + sign * step[1], s.elevation + sign * step[2]});
    };
    jacobian.col(i) = (at(1.0) - at(-1.0)) / (2.0 * h);
  }
  const Eigen::Vector3d sigmas(sensor.sigma_range, sensor.sigma_azimuth, sensor.sigma_elevation);
  const Eigen::Matrix3d expected =
      jacobian * sigmas.cwiseAbs2().asDiagonal() * jacobian.transpose();
  EXPECT_LT((PositionCovariance(FromSpherical(s), sensor) - expected).norm(), 1e-8);
}

TEST(PositionCovariance, IsPositiveDefiniteAtTheOrigin) {
  const SensorOptions sensor;
  const Eigen::Matrix3d covariance = PositionCovariance(Eigen::Vector3d::Zero(), sensor);
  EXPECT_LT((covariance - 0.0225 * Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

}  // namespace
}  // namespace radive
