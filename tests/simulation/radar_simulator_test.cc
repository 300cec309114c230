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
  options.returns = std::min(options.Sensor().returns_per_scan, 2000.0);
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

// Sum of `count` squared unit normals: within four standard deviations of its mean. `copies`: how
// many of them share an error on average.
void ExpectChiSquare(double sum, double count, double copies, const std::string& what) {
  EXPECT_NEAR(sum, count, 4.0 * std::sqrt(2.0 * count * copies)) << what;
}

// Scatterers of posts sit in their middle.
double ThickestPost(WorldType world) {
  double half_width = 0.0;
  for (const WorldStyle::Posts& posts : StyleOf(world).posts) {
    half_width = std::max(half_width, posts.half_width);
  }
  return half_width;
}

class EveryScenario : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scenarios,
                         EveryScenario,
                         ::testing::Values("street_dense",
                                           "street_sparse",
                                           "street_planar",
                                           "street_aeva",
                                           "avenue_dense",
                                           "campus_dense",
                                           "car_park_sparse",
                                           "tunnel_dense",
                                           "stop_and_go_sparse",
                                           "handcart_sparse",
                                           "outages_sparse"),
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
  const double copies = sensor.target_correlation > 0.0 ? 40.0 : 1.0;
  ExpectChiSquare(range, count, copies, "range");
  ExpectChiSquare(azimuth, count, copies, "azimuth");
  if (!sensor.is_planar) ExpectChiSquare(elevation, count, copies, "elevation");
  ExpectChiSquare(doppler, count, 1.0, "Doppler");
  // Marks of curved walls sit on the curve, not on its chords of 3 m.
  EXPECT_LT(farthest_from_surface, ThickestPost(simulator.options().world) + 0.035);
}

TEST_P(EveryScenario, ReturnsAreWithinTheView) {
  RadarSimulator simulator(SlowLap(GetParam()));
  const SensorModel sensor = simulator.sensor();
  RadarScan scan;
  GroundTruth truth;
  double total = 0.0, num_scans = 0.0;
  while (simulator.Next(&scan, &truth)) {
    num_scans += 1.0;
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
  EXPECT_NEAR(total / num_scans, sensor.returns_per_scan, 0.05 * sensor.returns_per_scan);
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
  const auto share = [&](ReturnLabel label) { return shares[static_cast<std::size_t>(label)]; };
  const SensorModel& sensor = simulator.sensor();
  EXPECT_GT(share(ReturnLabel::kStatic), 0.35);
  if (options.moving_cars > 0) {
    EXPECT_GT(share(ReturnLabel::kMoving), 0.004);
  } else {
    EXPECT_EQ(share(ReturnLabel::kMoving), 0.0);
  }
  const double scale = sensor.artefacts;
  EXPECT_NEAR(share(ReturnLabel::kGhost),
              scale * (options.ghost_share + options.ground_ghost_share),
              0.012);
  EXPECT_NEAR(share(ReturnLabel::kClutter), scale * options.clutter_share, 0.012);
  // Nothing shines through the walls of a tunnel.
  const bool is_closed = options.world == WorldType::kTunnel;
  const double duplicates = is_closed ? 0.0 : scale * options.duplicate_share;
  EXPECT_NEAR(share(ReturnLabel::kDuplicate), duplicates, 0.008);
  const double real = share(ReturnLabel::kStatic) + share(ReturnLabel::kMoving);
  EXPECT_NEAR(share(ReturnLabel::kAmbiguous), sensor.ambiguous_share * real, 0.015);
}

class EveryDrive : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scenarios,
                         EveryDrive,
                         ::testing::Values("street_planar", "campus_dense", "handcart_sparse"),
                         [](const auto& scenario) { return scenario.param; });

// Central differences of the poses at 50 Hz against v_radar.
TEST_P(EveryDrive, VelocityIsTheDerivativeOfThePoses) {
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
  EXPECT_LT(largest_error, 0.015);
  if (options.world != WorldType::kStreet) return;
  // Corner at 6 to 7 m/s with at most 0.052 / m: about 0.35 rad/s times a lever of 3.7 m.
  EXPECT_GT(largest_lateral, 0.8);
  EXPECT_LT(largest_lateral, 1.8);
}

// Share of the scans in which more than half of the returns move.
double ShareOfScansOwnedByMovers(const std::string& scenario) {
  RadarSimulator simulator(SlowLap(scenario));
  RadarScan scan;
  GroundTruth truth;
  double owned = 0.0, all = 0.0;
  while (simulator.Next(&scan, &truth)) {
    const auto moving = std::count(truth.labels.begin(), truth.labels.end(), ReturnLabel::kMoving);
    all += 1.0;
    if (2 * moving > static_cast<std::ptrdiff_t>(truth.labels.size())) owned += 1.0;
  }
  return owned / all;
}

TEST(RadarSimulator, ATruckOwnsMostReturnsOfStopAndGoTraffic) {
  EXPECT_GT(ShareOfScansOwnedByMovers("stop_and_go_dense"), 0.25);
  EXPECT_LT(ShareOfScansOwnedByMovers("street_dense"), 0.05);
}

// 15 s with scans, then 2 s without and 13 s with, again and again: at 1 Hz, of 120 scans those at
// 15, 16, 30, 31 ... 105, 106 s are missing.
TEST(RadarSimulator, OutagesSwallowScans) {
  SimulationOptions options = SlowLap("outages_sparse");
  RadarSimulator simulator(options);
  RadarScan scan;
  GroundTruth truth;
  std::set<std::int64_t> seconds;
  while (simulator.Next(&scan, &truth)) seconds.insert(scan.stamp_ns / 1000000000);
  EXPECT_EQ(seconds.size(), 120u - 14u);
  for (const std::int64_t second : {0, 1, 14, 17, 29, 32, 107})
    EXPECT_EQ(seconds.count(second), 1u);
  for (const std::int64_t second : {15, 16, 30, 31, 106}) EXPECT_EQ(seconds.count(second), 0u);

  // With a tenth of the returns left, no scan is missing and those are thin.
  options.outage_returns = 0.1;
  RadarSimulator thin(options);
  int scans = 0;
  for (; thin.Next(&scan, &truth); ++scans) {
    const std::int64_t second = scan.stamp_ns / 1000000000;
    EXPECT_EQ(scan.returns.size() < 30, second >= 15 && second % 15 < 2) << second;
  }
  EXPECT_EQ(scans, 120);
}

// A wrong elevation is off by the ambiguity of the antenna, at the true range and azimuth.
TEST(RadarSimulator, AmbiguousReturnsAreOffInElevationAlone) {
  SimulationOptions options = SlowLap("street_sparse", 60);
  options.ambiguity_scale = 10.0;
  RadarSimulator simulator(options);
  RadarScan scan;
  GroundTruth truth;
  int found = 0;
  while (simulator.Next(&scan, &truth)) {
    for (std::size_t i = 0; i < truth.labels.size(); ++i) {
      if (truth.labels[i] != ReturnLabel::kAmbiguous) continue;
      Spherical s = ToSpherical(truth.noise_free_positions[i]);
      double distance = 1e9;
      for (const double sign : {-1.0, 1.0}) {
        Spherical real = s;
        real.elevation += sign * simulator.sensor().elevation_ambiguity;
        const Eigen::Vector3d p_world = truth.T_world_radar * FromSpherical(real);
        distance = std::min(distance, simulator.world().DistanceToSurface(p_world));
      }
      // Those of moving cars lie on no surface of the static world.
      if (distance < 0.13) ++found;
    }
  }
  EXPECT_GT(found, 100);
}

// Without other artefacts, ghosts over flat ground lie below it, or on the line to them half-way;
// their Doppler is that of a static point to a fraction of the speed.
TEST(RadarSimulator, GroundGhostsComeFromBelow) {
  SimulationOptions options = SlowLap("street_dense", 60);
  options.ghost_share = options.clutter_share = options.duplicate_share = 0.0;
  options.ground_ghost_share = 0.2;
  options.moving_cars = 0;
  RadarSimulator simulator(options);
  RadarScan scan;
  GroundTruth truth;
  double ghosts = 0.0, below = 0.0;
  while (simulator.Next(&scan, &truth)) {
    for (std::size_t i = 0; i < truth.labels.size(); ++i) {
      if (truth.labels[i] != ReturnLabel::kGhost) continue;
      const Eigen::Vector3d& p = truth.noise_free_positions[i];
      ghosts += 1.0;
      if ((truth.T_world_radar * p).z() < 0.0) below += 1.0;
      EXPECT_NEAR(scan.returns[i].doppler, -p.normalized().dot(truth.v_radar), 1.0);
    }
  }
  EXPECT_GT(ghosts, 5000.0);
  EXPECT_GT(below / ghosts, 0.6);  // three kinds of four
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
  options.ghost_share = options.ground_ghost_share = 0.0;
  options.clutter_share = options.duplicate_share = options.ambiguity_scale = 0.0;
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
