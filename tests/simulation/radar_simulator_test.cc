// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/radar_simulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "radive/geometry/spherical.h"

namespace radive {
namespace {

// One scan a second over a whole lap, so that all of the street is seen.
SimulationOptions SlowLap(const std::string& scenario, int frames = 120) {
  SimulationOptions options = ScenarioOptions(scenario).value();
  options.rate = 1.0;
  options.frames = frames;
  return options;
}

std::vector<double> AllNumbers(const SimulationOptions& options) {
  RadarSimulator simulator(options);
  RadarScan scan;
  GroundTruth truth;
  std::vector<double> numbers;
  while (simulator.Next(&scan, &truth)) {
    numbers.push_back(static_cast<double>(scan.stamp_ns));
    for (const double value : ToPoseBlock(truth.T_world_radar)) numbers.push_back(value);
    for (std::size_t i = 0; i < scan.returns.size(); ++i) {
      const RadarReturn& entry = scan.returns[i];
      numbers.insert(numbers.end(), entry.position.data(), entry.position.data() + 3);
      numbers.push_back(entry.doppler);
      numbers.push_back(entry.power);
      numbers.push_back(static_cast<double>(truth.labels[i]));
    }
  }
  return numbers;
}

// Sum of `count` squared unit normals: within four standard deviations of its mean.
void ExpectChiSquare(double sum, double count, const std::string& what) {
  EXPECT_NEAR(sum, count, 4.0 * std::sqrt(2.0 * count)) << what;
}

class EveryScenario : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scenarios,
                         EveryScenario,
                         ::testing::Values("street_dense", "street_sparse", "street_planar"),
                         [](const auto& scenario) { return scenario.param; });

TEST_P(EveryScenario, SameSeedSameNumbersOtherSeedOthers) {
  SimulationOptions options = SlowLap(GetParam(), 4);
  const std::vector<double> first = AllNumbers(options);
  EXPECT_EQ(first, AllNumbers(options));
  options.frames = 3;
  const std::vector<double> shorter = AllNumbers(options);
  ASSERT_LT(shorter.size(), first.size());
  EXPECT_TRUE(std::equal(shorter.begin(), shorter.end(), first.begin())) << "frames is a prefix";
  options.frames = 4;
  options.seed = 2;
  EXPECT_NE(first, AllNumbers(options));
}

// Each measured quantity against its truth, in standard deviations, and static returns against
// the street itself.
TEST_P(EveryScenario, NoiseIsThatOfTheSensor) {
  RadarSimulator simulator(SlowLap(GetParam()));
  const SensorModel sensor = simulator.sensor();
  RadarScan scan;
  GroundTruth truth;
  double count = 0, range = 0, azimuth = 0, elevation = 0, doppler = 0;
  double farthest_from_surface = 0.0;
  while (simulator.Next(&scan, &truth)) {
    for (std::size_t i = 0; i < scan.returns.size(); ++i) {
      if (truth.labels[i] != ReturnLabel::kStatic) continue;
      const Eigen::Vector3d& position = truth.noise_free_positions[i];
      const Spherical t = ToSpherical(position);
      // Near the edge of the view only the noise that points inwards is ever seen.
      const double room = 5.0;
      if (std::abs(t.azimuth) + room * sensor.sigma_azimuth > sensor.azimuth.half_view ||
          std::abs(t.elevation) + room * sensor.sigma_elevation > sensor.elevation.half_view ||
          t.range + room * sensor.sigma_range > sensor.max_range ||
          t.range - room * sensor.sigma_range < sensor.min_range) {
        continue;
      }
      const Spherical m = ToSpherical(scan.returns[i].position);
      count += 1.0;
      range += std::pow((m.range - t.range) / sensor.sigma_range, 2);
      azimuth += std::pow((m.azimuth - t.azimuth) / sensor.sigma_azimuth, 2);
      if (!sensor.is_planar) {
        elevation += std::pow((m.elevation - t.elevation) / sensor.sigma_elevation, 2);
      }
      const double expected = -position.normalized().dot(truth.v_radar);
      doppler += std::pow((scan.returns[i].doppler - expected) / sensor.sigma_doppler, 2);
      if (i % 20 == 0) {
        farthest_from_surface =
            std::max(farthest_from_surface,
                     simulator.world().DistanceToSurface(truth.T_world_radar * position));
      }
    }
  }
  EXPECT_GT(count, 5000);
  ExpectChiSquare(range, count, "range");
  ExpectChiSquare(azimuth, count, "azimuth");
  if (!sensor.is_planar) ExpectChiSquare(elevation, count, "elevation");
  ExpectChiSquare(doppler, count, "Doppler");
  EXPECT_LT(farthest_from_surface, 0.121) << "scatterers of poles sit at their centre, 0.12 m in";
}

TEST_P(EveryScenario, ReturnsAreWithinTheView) {
  RadarSimulator simulator(SlowLap(GetParam()));
  const SensorModel sensor = simulator.sensor();
  RadarScan scan;
  GroundTruth truth;
  double total = 0.0;
  while (simulator.Next(&scan, &truth)) {
    EXPECT_TRUE(scan.has_doppler);
    EXPECT_EQ(scan.is_planar, sensor.is_planar);
    ASSERT_EQ(scan.returns.size(), truth.labels.size());
    ASSERT_EQ(scan.returns.size(), truth.noise_free_positions.size());
    total += static_cast<double>(scan.returns.size());
    for (const RadarReturn& entry : scan.returns) {
      ASSERT_TRUE(entry.position.allFinite() && std::isfinite(entry.doppler));
      const Spherical s = ToSpherical(entry.position);
      EXPECT_GE(s.range, sensor.min_range - 1e-9);
      EXPECT_LE(s.range, sensor.max_range + 1e-9);
      EXPECT_LE(std::abs(s.azimuth), sensor.azimuth.half_view + 1e-9);
      EXPECT_LE(std::abs(s.elevation), sensor.elevation.half_view + 1e-9);
      if (sensor.is_planar) {
        EXPECT_EQ(entry.position.z(), 0.0);
      }
    }
  }
  EXPECT_NEAR(total / 120.0, sensor.returns_per_scan, 0.05 * sensor.returns_per_scan);
}

TEST_P(EveryScenario, SharesOfTheLabels) {
  const SimulationOptions options = SlowLap(GetParam());
  RadarSimulator simulator(options);
  RadarScan scan;
  GroundTruth truth;
  std::array<double, kNumReturnLabels> shares = {};
  double total = 0.0;
  while (simulator.Next(&scan, &truth)) {
    for (const ReturnLabel label : truth.labels) shares[static_cast<std::size_t>(label)] += 1.0;
    total += static_cast<double>(truth.labels.size());
  }
  for (double& share : shares) share /= total;
  EXPECT_GT(shares[static_cast<std::size_t>(ReturnLabel::kStatic)], 0.75);
  EXPECT_GT(shares[static_cast<std::size_t>(ReturnLabel::kMoving)], 0.004);
  EXPECT_LT(shares[static_cast<std::size_t>(ReturnLabel::kMoving)], 0.12);
  EXPECT_NEAR(shares[static_cast<std::size_t>(ReturnLabel::kGhost)], options.ghost_share, 0.012);
  EXPECT_NEAR(
      shares[static_cast<std::size_t>(ReturnLabel::kClutter)], options.clutter_share, 0.012);
  EXPECT_NEAR(
      shares[static_cast<std::size_t>(ReturnLabel::kDuplicate)], options.duplicate_share, 0.008);
}

// Central differences of the poses at 50 Hz against v_radar.
TEST_P(EveryScenario, VelocityIsTheDerivativeOfThePoses) {
  SimulationOptions options = ScenarioOptions(GetParam()).value();
  options.rate = 50.0;
  options.frames = 2250;  // to the second side, over the first corner
  options.sensor = SensorType::kArs548;
  RadarSimulator simulator(options);
  RadarScan scan;
  std::array<GroundTruth, 3> truths;  // three scans in a row
  double largest_error = 0.0, largest_lateral = 0.0;
  for (int k = 0; simulator.Next(&scan, &truths[2]); ++k) {
    if (k >= 2) {
      const Eigen::Vector3d v_world =
          (truths[2].T_world_radar.translation - truths[0].T_world_radar.translation) * 25.0;
      const Eigen::Vector3d v_radar = truths[1].T_world_radar.rotation.conjugate() * v_world;
      largest_error = std::max(largest_error, (v_radar - truths[1].v_radar).norm());
      const Eigen::AngleAxisd to_car(options.mount_yaw, Eigen::Vector3d::UnitZ());
      largest_lateral = std::max(largest_lateral, (to_car * truths[1].v_radar).y());
    }
    truths[0] = truths[1];
    truths[1] = truths[2];
  }
  EXPECT_LT(largest_error, 0.01);
  // Corner at 6 to 7 m/s with at most 0.052 / m: about 0.35 rad/s times a lever of 3.7 m.
  EXPECT_GT(largest_lateral, 0.8);
  EXPECT_LT(largest_lateral, 1.8);
}

TEST(RadarSimulator, StartsAtTheMountAndStands) {
  SimulationOptions options = ScenarioOptions("street_planar").value();
  options.frames = 1;
  options.wobble = 0.0;
  RadarSimulator simulator(options);
  RadarScan scan;
  GroundTruth truth;
  ASSERT_TRUE(simulator.Next(&scan, &truth));
  EXPECT_LT((truth.T_world_radar.translation - Eigen::Vector3d(3.86, -0.7, 0.6)).norm(), 1e-12);
  EXPECT_NEAR(RotationVector(truth.T_world_radar.rotation).z(), -0.436, 1e-12);
  EXPECT_EQ(truth.v_radar.norm(), 0.0);
  EXPECT_FALSE(simulator.Next(&scan, &truth));
}

TEST(RadarSimulator, StampsAreRoundedNanoseconds) {
  const RadarSimulator simulator(ScenarioOptions("street_dense").value());
  EXPECT_EQ(simulator.StampOf(0), 0);
  EXPECT_EQ(simulator.StampOf(1), 83333333);
  EXPECT_EQ(simulator.StampOf(12), 1000000000);
}

// Without noise and artefacts, every static return gives the velocity back exactly.
TEST(RadarSimulator, NoiseCanBeSwitchedOff) {
  SimulationOptions options = SlowLap("street_sparse", 30);
  options.noise_scale = 0.0;
  options.ghost_share = options.clutter_share = options.duplicate_share = 0.0;
  options.moving_cars = 0;
  RadarSimulator simulator(options);
  RadarScan scan;
  GroundTruth truth;
  while (simulator.Next(&scan, &truth)) {
    for (std::size_t i = 0; i < scan.returns.size(); ++i) {
      ASSERT_EQ(truth.labels[i], ReturnLabel::kStatic);
      const Eigen::Vector3d direction = scan.returns[i].position.normalized();
      EXPECT_NEAR(scan.returns[i].doppler, -direction.dot(truth.v_radar), 1e-9);
    }
  }
}

// The sparse radar sees the same places again: most of its static returns of two neighbouring
// scans stem from common surface points.
TEST(RadarSimulator, ScatterersRepeat) {
  SimulationOptions options = ScenarioOptions("street_sparse").value();
  options.frames = 2;  // standing
  RadarSimulator simulator(options);
  RadarScan scan;
  std::array<GroundTruth, 2> truths;
  ASSERT_TRUE(simulator.Next(&scan, &truths[0]));
  ASSERT_TRUE(simulator.Next(&scan, &truths[1]));
  const auto key = [](const Eigen::Vector3d& p) {
    return std::to_string(std::llround(p.x() * 1e6)) + " " +
           std::to_string(std::llround(p.y() * 1e6));
  };
  std::set<std::string> seen;
  for (const Eigen::Vector3d& p : truths[0].noise_free_positions) seen.insert(key(p));
  double repeated = 0.0;
  for (const Eigen::Vector3d& p : truths[1].noise_free_positions) {
    repeated += seen.count(key(p)) > 0 ? 1.0 : 0.0;
  }
  EXPECT_GT(repeated / static_cast<double>(truths[1].labels.size()), 0.2);
}

TEST(SimulationOptions, SaysWhatIsOutOfRange) {
  std::string error;
  SimulationOptions options;
  EXPECT_TRUE(options.IsValid(&error));
  options.noise_scale = -1.0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "simulation.noise_scale must be >= 0 and <= 10, is -1");
  options = SimulationOptions();
  options.ghost_share = options.clutter_share = 0.5;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("must be < 0.95"), std::string::npos) << error;
  options = SimulationOptions();
  options.mount_position = {1.0, 2.0};
  EXPECT_FALSE(options.IsValid(&error));
  options.mount_position = {1.0, 2.0, 0.0};
  EXPECT_FALSE(options.IsValid(&error));
}

TEST(SimulationOptions, EveryScenarioNameHasValidOptions) {
  std::string error;
  for (const std::string& name : ScenarioNames()) {
    const auto options = ScenarioOptions(name);
    ASSERT_TRUE(options) << name;
    EXPECT_TRUE(options->IsValid(&error)) << error;
  }
  EXPECT_FALSE(ScenarioOptions("street"));
}

}  // namespace
}  // namespace radive
