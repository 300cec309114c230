// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The covariance of registration, against the errors that it really makes: many noisy scans of one
// scene, registered to a fixed map. The error squared over its covariance has the mean of the
// degrees of freedom when the covariance is honest. The map is exact here: that the submap has
// errors of its own, which all scans against it share, is not part of the covariance.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <iostream>

#include "radive/ndt/gaussian_builder.h"
#include "radive/registration/registration.h"
#include "radive/sensor/radar_noise_model.h"
#include "tests/synthetic_scene.h"

namespace radive {
namespace {

constexpr int kNumScans = 400;

SensorOptions Sensor() {
  SensorOptions sensor;
  sensor.sigma_range = 0.1;
  sensor.sigma_azimuth = 0.006;
  sensor.sigma_elevation = 0.012;
  return sensor;
}

NdtOptions Ndt() {
  NdtOptions options;
  options.epsilon = 0.02;
  return options;
}

// The street's points as they are measured from the pose, with the noise of the sensor.
std::vector<Gaussian3> NoisyScan(const std::vector<Eigen::Vector3d>& points,
                                 const Rigid3& T_submap_radar,
                                 Random* random) {
  std::vector<RadarReturn> returns;
  for (const Eigen::Vector3d& p : points) {
    RadarReturn entry;
    entry.position = T_submap_radar.Inverse() * p;
    entry.position += testing::RandomDraw(PositionCovariance(entry.position, Sensor()), random);
    returns.push_back(entry);
  }
  return GaussiansOfReturns(returns, std::vector<double>(returns.size(), 1.0), Sensor(), Ndt());
}

// Mean of the normalised error squared of many scans against a map of exact points.
double MeanNormalisedError(bool planar, int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  // Well apart, so that each point has one partner.
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 200; ++i) {
    points.emplace_back(
        random.Uniform(-40.0, 40.0), random.Uniform(-25.0, 25.0), random.Uniform(-1.0, 6.0));
  }
  std::vector<Gaussian3> submap;
  for (const Eigen::Vector3d& p : points) {
    Gaussian3 gaussian;
    gaussian.mean = p;
    gaussian.covariance = 0.02 * Eigen::Matrix3d::Identity();
    submap.push_back(gaussian);
  }
  const PairSearch search(submap);
  RegistrationPriors priors;
  if (planar) priors.plane_normal = Eigen::Vector3d::UnitZ();
  RegistrationOptions options;
  options.max_iterations = 100;
  options.step_tolerance = 1e-6;
  options.step_deviations = 0.0;
  double sum = 0.0;
  for (int i = 0; i < kNumScans; ++i) {
    const Rigid3 T_true{QuaternionFromRotationVector({0.0, 0.0, random.Uniform(-3.0, 3.0)}),
                        {random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0), 1.0}};
    const std::vector<Gaussian3> scan = NoisyScan(points, T_true, &random);
    const RegistrationResult result =
        RegisterNdt(scan, search, T_true, 0.3, priors, PairOptions(), options);
    EXPECT_TRUE(result.converged) << result.message;
    Eigen::Matrix<double, 6, 1> error;
    error << RotationVector(T_true.rotation * result.T_submap_radar.rotation.conjugate()),
        T_true.translation - result.T_submap_radar.translation;
    if (planar) {
      const Eigen::Vector3d e(error[2], error[3], error[4]);
      sum += e.dot(result.covariance.block<3, 3>(2, 2).llt().solve(e));
    } else {
      sum += error.dot(result.covariance.llt().solve(error));
    }
  }
  return sum / kNumScans;
}

TEST(RegistrationCovariance, ErrorsOfPlanarPosesAreWithinTheChiSquareBand) {
  const double mean = MeanNormalisedError(/*planar=*/true, 1);
  std::cout << "mean NEES of 3 DoF: " << mean << "\n";
  EXPECT_NEAR(mean, 3.0, 2.58 * std::sqrt(2.0 * 3.0 / kNumScans));
}

TEST(RegistrationCovariance, ErrorsOfFreePosesAreWithinTheChiSquareBand) {
  const double mean = MeanNormalisedError(/*planar=*/false, 2);
  std::cout << "mean NEES of 6 DoF: " << mean << "\n";
  EXPECT_NEAR(mean, 6.0, 2.58 * std::sqrt(2.0 * 6.0 / kNumScans));
}

}  // namespace
}  // namespace radive
