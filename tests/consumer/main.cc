// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// What a user of the installed library does: our factors in a problem of their own, and scans
// through the odometry. Ends with 0 when the results are right.

#include <ceres/ceres.h>

#include <cmath>
#include <cstdio>

#include "radive/factors/doppler_factor.h"
#include "radive/factors/translation_prior_factor.h"
#include "radive/geometry/rigid3.h"
#include "radive/odometry/odometry.h"

namespace {

// Static returns ahead and to the left of a radar with the velocity (3, -2, 0): -3 and +2 m/s.
bool DopplerFactorsWork() {
  Eigen::Vector3d v_radar = Eigen::Vector3d::Zero();
  ceres::Problem problem;
  const auto add = [&](const Eigen::Vector3d& direction, double v_doppler) {
    problem.AddResidualBlock(
        radive::DopplerFactor::Create(direction, v_doppler, 0.1), nullptr, v_radar.data());
  };
  add(Eigen::Vector3d::UnitX(), -3.0);
  add(Eigen::Vector3d::UnitY(), 2.0);
  add(Eigen::Vector3d::UnitZ(), 0.0);
  ceres::Solver::Summary summary;
  ceres::Solve(ceres::Solver::Options(), &problem, &summary);
  std::printf("velocity: %.6f %.6f %.6f m/s\n", v_radar.x(), v_radar.y(), v_radar.z());
  return (v_radar - Eigen::Vector3d(3.0, -2.0, 0.0)).norm() < 1e-5;
}

// Two priors on one position, the second with half the standard deviation: the minimum lies at
// (1 * 0 + 4 * 5) / 5 = 4 m.
bool PoseFactorsWork() {
  radive::PoseBlock T_submap_radar = radive::ToPoseBlock(radive::Rigid3());
  ceres::Problem problem;
  problem.AddResidualBlock(radive::TranslationPriorFactor::Create(Eigen::Vector3d(0.0, 0.0, 0.0),
                                                                  Eigen::Matrix3d::Identity()),
                           nullptr,
                           T_submap_radar.data());
  problem.AddResidualBlock(radive::TranslationPriorFactor::Create(
                               Eigen::Vector3d(5.0, 0.0, 0.0), 2.0 * Eigen::Matrix3d::Identity()),
                           nullptr,
                           T_submap_radar.data());
  problem.SetManifold(
      T_submap_radar.data(),
      new ceres::ProductManifold<ceres::EigenQuaternionManifold, ceres::EuclideanManifold<3>>());
  ceres::Solver::Summary summary;
  ceres::Solve(ceres::Solver::Options(), &problem, &summary);
  std::printf("pose: x = %.9f m\n", T_submap_radar[4]);
  return std::abs(T_submap_radar[4] - 4.0) < 1e-3;
}

bool OdometryWorks() {
  radive::Odometry odometry((radive::OdometryOptions()));
  radive::OdometryResult result;
  for (int i = 0; i < 5; ++i) {
    radive::RadarScan scan;
    scan.stamp_ns = 100'000'000LL * i;
    for (int k = 0; k < 50; ++k) {
      radive::RadarReturn ret;
      ret.position = {10.0 + 0.3 * k, 15.0 * std::sin(0.5 * k), std::cos(1.1 * k)};
      ret.doppler = 0.0;
      scan.returns.push_back(ret);
    }
    scan.has_doppler = true;
    result = odometry.AddScan(scan);
  }
  std::printf("odometry: scan %d, %s\n", result.index, radive::ToString(result.status));
  // The same scan again and again, with zero Doppler: the radar stands.
  return result.index == 4 && result.T_world_radar.translation.norm() < 0.05;
}

}  // namespace

int main() { return DopplerFactorsWork() && PoseFactorsWork() && OdometryWorks() ? 0 : 1; }
