// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/geometry/rigid3.h"
#include "radive/registration/registration_options.h"
#include "radive/util/random.h"
#include "tests/synthetic_scene.h"

// Scans of the synthetic street for tests of registration.

namespace radive::testing {

// Each point as a Gaussian, displaced by that much noise.
inline std::vector<Gaussian3> PointGaussians(const std::vector<Eigen::Vector3d>& points,
                                             double sigma,
                                             Random* random) {
  std::vector<Gaussian3> gaussians;
  for (const Eigen::Vector3d& p : points) {
    Gaussian3 gaussian;
    gaussian.mean = p + sigma * RandomNormal3(random);
    gaussian.covariance = 0.03 * Eigen::Matrix3d::Identity();
    gaussians.push_back(gaussian);
  }
  return gaussians;
}

// Every second point of the street as the radar sees it, in the radar frame.
inline std::vector<Gaussian3> StreetScan(const Rigid3& T_submap_radar,
                                         double sigma,
                                         Random* random) {
  std::vector<Eigen::Vector3d> points;
  const std::vector<Eigen::Vector3d> street = StreetPoints();
  for (std::size_t i = 0; i < street.size(); i += 2) {
    points.push_back(T_submap_radar.Inverse() * street[i]);
  }
  return PointGaussians(points, sigma, random);
}

inline double RotationError(const Rigid3& a, const Rigid3& b) {
  return RotationVector(a.rotation * b.rotation.conjugate()).norm();
}

// Enough steps to be at the minimum.
inline RegistrationOptions Patient() {
  RegistrationOptions options;
  options.max_iterations = 100;
  options.step_tolerance = 1e-7;
  options.step_deviations = 0.0;
  return options;
}

}  // namespace radive::testing
