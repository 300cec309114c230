// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/geometry/rigid3.h"
#include "radive/ndt/gaussian_builder.h"
#include "radive/simulation/radar_simulator.h"

namespace radive {

// A scan of the simulated street and the submap of the scans before it, at their true poses: what
// registration works on. Sparse: points of 30 keyframes; dense: voxels of 15.
struct StreetScene {
  std::vector<Eigen::Vector3d> points;  // of the last scan, radar frame [m]
  std::vector<Gaussian3> scan;          // radar frame
  std::vector<Gaussian3> submap;
  Rigid3 T_submap_radar;  // true

  std::vector<RadarReturn> returns;  // of the last scan
  Rigid3 T_submap_radar0;            // of the scan before, true
  double dt = 0.0;                   // between both [s]
};

inline StreetScene MakeStreetScene(bool dense) {
  SimulationOptions simulation = ScenarioOptions(dense ? "street_dense" : "street_sparse").value();
  simulation.frames = dense ? 17 : 32;
  simulation.rate = 2.0;
  RadarSimulator simulator(simulation);
  NdtOptions ndt;
  if (dense) ndt.representation = NdtOptions::Representation::kVoxel;
  const SensorOptions sensor;
  StreetScene scene;
  scene.dt = 1.0 / simulation.rate;
  std::vector<Eigen::Vector3d> submap_points;
  RadarScan scan;
  GroundTruth truth;
  for (int k = 0; simulator.Next(&scan, &truth); ++k) {
    scene.points.clear();
    std::vector<RadarReturn> returns;
    scene.T_submap_radar0 = scene.T_submap_radar;
    for (std::size_t i = 0; i < scan.returns.size(); ++i) {
      const double range = scan.returns[i].position.norm();
      if (truth.labels[i] == ReturnLabel::kMoving || range > 100.0) continue;
      returns.push_back(scan.returns[i]);
      scene.points.push_back(scan.returns[i].position);
    }
    const std::vector<double> weights(returns.size(), 1.0);
    scene.scan = dense ? GaussiansOfVoxels(scene.points, weights, ndt)
                       : GaussiansOfReturns(returns, weights, sensor, ndt);
    scene.T_submap_radar = truth.T_world_radar;
    scene.returns = returns;
    if (k + 1 == simulation.frames) break;
    const Eigen::Matrix3d R = truth.T_world_radar.RotationMatrix();
    for (const Eigen::Vector3d& p : scene.points) submap_points.push_back(truth.T_world_radar * p);
    if (dense) continue;
    for (Gaussian3 gaussian : scene.scan) {
      gaussian.mean = truth.T_world_radar * gaussian.mean;
      gaussian.covariance = R * gaussian.covariance * R.transpose();
      scene.submap.push_back(gaussian);
    }
  }
  if (dense) {
    scene.submap =
        GaussiansOfVoxels(submap_points, std::vector<double>(submap_points.size(), 1.0), ndt);
  }
  return scene;
}

// Built once, by the first benchmark that asks.
inline const StreetScene& GetStreetScene(bool dense) {
  static const StreetScene scenes[] = {MakeStreetScene(false), MakeStreetScene(true)};
  return scenes[dense ? 1 : 0];
}

}  // namespace radive
