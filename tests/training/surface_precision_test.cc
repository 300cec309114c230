// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "radive/neural_map/surface_extractor.h"
#include "radive/sensor/radar_noise_model.h"
#include "radive/simulation/radar_simulator.h"
#include "radive/training/sdf_mapper.h"

// How near to the true surfaces of a simulated street the points lie that extraction trusts.

namespace radive {
namespace {

constexpr int kKeyframes = 9;
constexpr double kKeyframeDistance = 2.0;  // [m]
constexpr double kMaxRange = 60.0;         // [m]
constexpr double kNear = 0.3;              // [m]

MapKeyframe KeyframeOf(const RadarScan& scan, const GroundTruth& truth) {
  MapKeyframe keyframe;
  keyframe.origin = truth.T_world_radar.translation;
  keyframe.is_planar = scan.is_planar;
  const Eigen::Matrix3d R = truth.T_world_radar.RotationMatrix();
  for (std::size_t i = 0; i < scan.returns.size(); ++i) {
    // Doppler takes out what moves; ghosts, clutter and second echoes stay.
    const Eigen::Vector3d& p_radar = scan.returns[i].position;
    if (truth.labels[i] == ReturnLabel::kMoving || p_radar.norm() > kMaxRange) continue;
    MapReturn entry;
    entry.position = truth.T_world_radar * p_radar;
    entry.covariance =
        R * PositionCovariance(p_radar, SensorOptions(), scan.is_planar) * R.transpose();
    keyframe.returns.push_back(entry);
  }
  return keyframe;
}

struct Precision {
  double of_all = 0.0;      // share of neural points within kNear of a surface, as they are [-]
  double of_trusted = 0.0;  // ... of the fifth that has most support, moved to the field's zero [-]
};

Precision PrecisionOn(int seed) {
  SimulationOptions simulation = ScenarioOptions("street_dense").value();
  simulation.seed = seed;
  RadarSimulator simulator(simulation);
  NeuralMapOptions map_options;
  map_options.resolution = 0.3;
  SdfMapper mapper(map_options, SdfTrainingOptions());
  RadarScan scan;
  GroundTruth truth;
  Eigen::Vector3d last = Eigen::Vector3d::Constant(1e9);
  for (int k = 0; k < kKeyframes && simulator.Next(&scan, &truth);) {
    if ((truth.T_world_radar.translation - last).norm() < kKeyframeDistance) continue;
    last = truth.T_world_radar.translation;
    mapper.AddKeyframe(KeyframeOf(scan, truth));
    ++k;
  }
  SurfaceOptions all;
  all.min_support = 0.0;
  all.trial_keyframes = 0;
  all.threshold = 1.0;
  std::vector<SurfacePoint> points = ExtractSurface(mapper.map(), mapper.decoder(), all);
  std::stable_sort(points.begin(), points.end(), [](const SurfacePoint& a, const SurfacePoint& b) {
    return a.support > b.support;
  });
  const RadarWorld& world = simulator.world();
  const std::size_t num_kept = static_cast<std::size_t>(mapper.map().size()) / 5;
  Precision precision;
  for (std::size_t i = 0; i < num_kept; ++i) {
    precision.of_trusted += world.DistanceToSurface(points[i].position) < kNear ? 1.0 : 0.0;
  }
  for (const NeuralPoint& point : mapper.map().points()) {
    precision.of_all += world.DistanceToSurface(point.position) < kNear ? 1.0 : 0.0;
  }
  precision.of_trusted /= static_cast<double>(num_kept);
  precision.of_all /= static_cast<double>(mapper.map().size());
  return precision;
}

TEST(SurfacePrecision, OfAFifthNineInTenLieOnASurface) {
  std::vector<double> of_trusted;
  for (const int seed : {1, 2, 3, 4, 5}) {
    const Precision precision = PrecisionOn(seed);
    std::cout << "street " << seed << ": " << precision.of_trusted << " of the trusted fifth, "
              << precision.of_all << " of all\n";
    EXPECT_GT(precision.of_trusted, precision.of_all + 0.25);
    of_trusted.push_back(precision.of_trusted);
  }
  std::sort(of_trusted.begin(), of_trusted.end());
  EXPECT_GE(of_trusted[2], 0.9) << "median of five streets";
}

}  // namespace
}  // namespace radive
