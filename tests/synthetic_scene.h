// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/geometry/rigid3.h"
#include "radive/ndt/distance_bounded_pairs.h"
#include "radive/util/random.h"

// Random poses and Gaussians, and small scenes of walls and poles, for the tests of the core.

namespace radive::testing {

inline Eigen::Vector3d RandomNormal3(Random* random) {
  const double x = random->Normal();
  const double y = random->Normal();
  return {x, y, random->Normal()};
}

inline Eigen::Vector3d RandomUnit3(Random* random) { return RandomNormal3(random).normalized(); }

// Uniformly random direction of rotation and translation; sizes uniform up to `max_angle` [rad] and
// `max_distance` [m].
inline Rigid3 RandomRigid3(double max_angle, double max_distance, Random* random) {
  const Eigen::Vector3d rotation = random->Uniform(0.0, max_angle) * RandomUnit3(random);
  const Eigen::Vector3d translation = random->Uniform(0.0, max_distance) * RandomUnit3(random);
  return {QuaternionFromRotationVector(rotation), translation};
}

// Full covariance with random axes and standard deviations between the two given [m].
inline Eigen::Matrix3d RandomCovariance(double min_sigma, double max_sigma, Random* random) {
  const Eigen::Matrix3d axes =
      QuaternionFromRotationVector(3.0 * RandomNormal3(random)).toRotationMatrix();
  Eigen::Vector3d variances;
  for (int i = 0; i < 3; ++i) variances[i] = std::pow(random->Uniform(min_sigma, max_sigma), 2);
  return axes * variances.asDiagonal() * axes.transpose();
}

// A draw of N(0, covariance).
inline Eigen::Vector3d RandomDraw(const Eigen::Matrix3d& covariance, Random* random) {
  return covariance.llt().matrixL() * RandomNormal3(random);
}

inline Gaussian3 Transformed(const Rigid3& T_a_b, const Gaussian3& gaussian_b) {
  const Eigen::Matrix3d R = T_a_b.RotationMatrix();
  Gaussian3 gaussian_a = gaussian_b;
  gaussian_a.mean = T_a_b * gaussian_b.mean;
  gaussian_a.covariance = R * gaussian_b.covariance * R.transpose();
  return gaussian_a;
}

inline std::vector<Gaussian3> Transformed(const Rigid3& T_a_b,
                                          const std::vector<Gaussian3>& gaussians_b) {
  std::vector<Gaussian3> gaussians_a;
  for (const Gaussian3& gaussian : gaussians_b) gaussians_a.push_back(Transformed(T_a_b, gaussian));
  return gaussians_a;
}

// Gaussians spread evenly over a box of +-`extent` [m], with random shapes and weights.
inline std::vector<Gaussian3> RandomGaussians(int count,
                                              const Eigen::Vector3d& extent,
                                              Random* random) {
  std::vector<Gaussian3> gaussians;
  for (int i = 0; i < count; ++i) {
    Gaussian3 gaussian;
    for (int k = 0; k < 3; ++k) gaussian.mean[k] = random->Uniform(-extent[k], extent[k]);
    gaussian.covariance = RandomCovariance(0.2, 0.8, random);
    gaussian.weight = random->Uniform(0.2, 1.0);
    gaussians.push_back(gaussian);
  }
  return gaussians;
}

inline std::vector<NdtPair> AllPairs(std::size_t num_scan, std::size_t num_submap) {
  std::vector<NdtPair> pairs;
  for (std::size_t i = 0; i < num_scan; ++i) {
    for (std::size_t j = 0; j < num_submap; ++j) {
      pairs.push_back({static_cast<int>(i), static_cast<int>(j)});
    }
  }
  return pairs;
}

// A street about the origin, 80 m long: facades with bays on both sides (y = -8 and 9 m), a wall
// across its end, and poles. Points on their surfaces, in the world frame [m].
inline std::vector<Eigen::Vector3d> StreetPoints() {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 53; ++i) {
    const double x = -40.0 + 1.5 * i;
    const double bay = (i / 4) % 2 == 0 ? 0.0 : 1.5;
    for (const double z : {0.3, 2.0, 3.7}) {
      points.emplace_back(x, -8.0 - bay, z);
      points.emplace_back(x + 0.7, 9.0 + bay, z);
    }
  }
  for (int i = 0; i < 10; ++i) points.emplace_back(42.0, -7.0 + 1.6 * i, 1.0 + 0.3 * i);
  for (int i = 0; i < 8; ++i) {
    for (const double z : {0.4, 1.6, 2.8}) {
      points.emplace_back(-36.0 + 9.5 * i, -5.0, z);
      points.emplace_back(-31.0 + 9.5 * i, 6.0, z);
    }
  }
  return points;
}

}  // namespace radive::testing
