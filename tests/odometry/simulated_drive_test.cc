// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Odometry over whole simulated drives, against the truth.

#include "tests/simulated_drive.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <numeric>

namespace radive {
namespace {

using testing::Compare;
using testing::Drive;
using testing::DriveErrors;
using testing::OptionsFor;
using testing::RunOdometry;
using testing::Scenario;
using testing::SimulateDrive;

void Report(const DriveErrors& errors) {
  std::cout << errors.length << " m: rmse " << errors.rmse << " m, end " << errors.end
            << " m, heading " << errors.max_rotation << " rad, " << errors.num_registered
            << " registered\n";
}

// Everything that goes into the results, but for the times.
std::vector<double> Numbers(const std::vector<OdometryResult>& results) {
  std::vector<double> numbers;
  for (const OdometryResult& result : results) {
    for (const double value : ToPoseBlock(result.T_world_radar)) numbers.push_back(value);
    numbers.insert(numbers.end(), result.covariance.data(), result.covariance.data() + 36);
    numbers.insert(numbers.end(),
                   {static_cast<double>(result.status),
                    static_cast<double>(result.num_pairs),
                    static_cast<double>(result.num_iterations),
                    static_cast<double>(result.num_kept),
                    static_cast<double>(result.is_keyframe),
                    result.cost,
                    result.ego_velocity.v_radar.x(),
                    result.ego_velocity.v_radar.y()});
  }
  return numbers;
}

TEST(SimulatedDrive, SparseStreet) {
  const Drive drive = SimulateDrive(Scenario("street_sparse", 600));
  const DriveErrors errors = Compare(drive, RunOdometry(OptionsFor(drive.simulation), drive.scans));
  Report(errors);
  EXPECT_GT(errors.length, 150.0);
  EXPECT_LT(errors.rmse, 0.01 * errors.length);
  EXPECT_LT(errors.max_rotation, 0.03);
}

TEST(SimulatedDrive, PlanarStreet) {
  const Drive drive = SimulateDrive(Scenario("street_planar", 500));
  const DriveErrors errors = Compare(drive, RunOdometry(OptionsFor(drive.simulation), drive.scans));
  Report(errors);
  EXPECT_GT(errors.length, 150.0);
  EXPECT_LT(errors.rmse, 0.01 * errors.length);
  EXPECT_LT(errors.max_rotation, 0.03);
}

TEST(SimulatedDrive, DenseStreet) {
  SimulationOptions simulation = Scenario("street_dense", 150);
  simulation.rate = 6.0;
  const Drive drive = SimulateDrive(simulation);
  const DriveErrors errors = Compare(drive, RunOdometry(OptionsFor(drive.simulation), drive.scans));
  Report(errors);
  EXPECT_GT(errors.length, 100.0);
  EXPECT_LT(errors.rmse, 0.01 * errors.length);
  EXPECT_LT(errors.max_rotation, 0.03);
}

// Without the help of Doppler, plane and vehicle: registration alone.
TEST(SimulatedDrive, ScansWithoutDoppler) {
  SimulationOptions simulation = Scenario("street_sparse", 600);
  simulation.moving_cars = 0;
  Drive drive = SimulateDrive(simulation);
  for (RadarScan& scan : drive.scans) {
    scan.has_doppler = false;
    for (RadarReturn& entry : scan.returns) {
      entry.doppler = std::numeric_limits<double>::quiet_NaN();
    }
  }
  Odometry odometry(OptionsFor(simulation));
  std::vector<OdometryResult> results;
  for (const RadarScan& scan : drive.scans) results.push_back(odometry.AddScan(scan));
  const DriveErrors errors = Compare(drive, results);
  Report(errors);
  EXPECT_LT(errors.rmse, 0.02 * errors.length);
  const std::vector<std::string> notes = odometry.TakeNotes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("no Doppler"), std::string::npos) << notes[0];
  EXPECT_TRUE(odometry.TakeNotes().empty()) << "said once";
}

// Radars that look to the left, to the right and back.
TEST(SimulatedDrive, SideAndRearFacingRadars) {
  for (const double yaw : {1.5708, -1.5708, 3.14159}) {
    SimulationOptions simulation = Scenario("street_sparse", 500);
    simulation.mount_yaw = yaw;
    simulation.mount_position = {std::abs(yaw) > 3.0 ? -0.9 : 3.4, yaw > 1.0 ? 0.7 : -0.7, 0.6};
    const Drive drive = SimulateDrive(simulation);
    const DriveErrors errors = Compare(drive, RunOdometry(OptionsFor(simulation), drive.scans));
    Report(errors);
    EXPECT_GT(errors.length, 100.0);
    EXPECT_LT(errors.rmse, 0.03 * errors.length) << yaw;
  }
}

// The drive played backwards: the car drives in reverse.
TEST(SimulatedDrive, ReverseDriving) {
  Drive drive = SimulateDrive(Scenario("street_sparse", 500));
  const std::int64_t end = drive.scans.back().stamp_ns;
  std::reverse(drive.scans.begin(), drive.scans.end());
  std::reverse(drive.truths.begin(), drive.truths.end());
  for (RadarScan& scan : drive.scans) {
    scan.stamp_ns = end - scan.stamp_ns;
    for (RadarReturn& entry : scan.returns) entry.doppler *= -1.0;
  }
  const std::vector<OdometryResult> results =
      RunOdometry(OptionsFor(drive.simulation), drive.scans);
  const DriveErrors errors = Compare(drive, results);
  Report(errors);
  EXPECT_LT(results[100].ego_velocity.v_radar.x(), -3.0) << "backwards";
  EXPECT_LT(errors.rmse, 0.01 * errors.length);
}

TEST(SimulatedDrive, SameInputSameBytes) {
  const Drive drive = SimulateDrive(Scenario("street_sparse", 200));
  OdometryOptions options = OptionsFor(drive.simulation);
  const std::vector<double> first = Numbers(RunOdometry(options, drive.scans));
  EXPECT_EQ(first, Numbers(RunOdometry(options, drive.scans)));
  options.num_threads = 4;
  EXPECT_EQ(first, Numbers(RunOdometry(options, drive.scans))) << "threads change nothing";
}

// The first half of a drive does not know what follows.
TEST(SimulatedDrive, IsCausal) {
  const Drive drive = SimulateDrive(Scenario("street_sparse", 200));
  const OdometryOptions options = OptionsFor(drive.simulation);
  const std::vector<OdometryResult> all = RunOdometry(options, drive.scans);
  const std::vector<RadarScan> half(drive.scans.begin(), drive.scans.begin() + 100);
  EXPECT_EQ(Numbers(RunOdometry(options, half)),
            Numbers(std::vector<OdometryResult>(all.begin(), all.begin() + 100)));
}

// Seconds without a scan: three on straights, with traffic, and one in a corner. Over three seconds
// in a corner this sparse sensor sees nothing that it saw before.
TEST(SimulatedDrive, GoesOnAfterAnOutage) {
  struct Outage {
    std::size_t begin;  // first scan that is missing
    double duration;    // [s]
  };
  const Drive whole = SimulateDrive(Scenario("street_sparse", 760));
  for (const Outage& outage : {Outage{140, 3.0}, {250, 3.0}, {380, 3.0}, {660, 1.0}}) {
    Drive drive = whole;
    const std::size_t begin = outage.begin;
    const auto cut = [&](auto* list) {
      const auto first = list->begin() + static_cast<std::ptrdiff_t>(begin);
      list->erase(first, first + static_cast<std::ptrdiff_t>(20.0 * outage.duration));
      list->resize(begin + 60);
    };
    cut(&drive.scans);
    cut(&drive.truths);
    const std::vector<OdometryResult> results =
        RunOdometry(OptionsFor(drive.simulation), drive.scans);
    Report(Compare(drive, results));
    // The motion over the outage, and that until two seconds later.
    for (const std::size_t after : {std::size_t{0}, std::size_t{40}}) {
      const Rigid3 estimated =
          results[begin - 1].T_world_radar.Inverse() * results[begin + after].T_world_radar;
      const Rigid3 truth = drive.truths[begin - 1].T_world_radar.Inverse() *
                           drive.truths[begin + after].T_world_radar;
      EXPECT_LT((estimated.translation - truth.translation).head<2>().norm(), 0.6)
          << begin << " + " << after << " of " << truth.translation.norm() << " m";
      const double turned = RotationVector(estimated.rotation * truth.rotation.conjugate()).z();
      EXPECT_LT(std::abs(turned), 0.03) << begin << " + " << after;
      EXPECT_EQ(results[begin + after].status, OdometryResult::Status::kRegistered);
    }
  }
}

// A loop driven again and again: neither time nor the submap grow.
TEST(SimulatedDrive, TimeAScanDoesNotGrowWithTheDrive) {
  SimulationOptions simulation = Scenario("street_planar", 400);
  simulation.moving_cars = 0;
  const Drive drive = SimulateDrive(simulation);
  constexpr int kNumScans = 5000;
  OdometryOptions options = OptionsFor(simulation);
  options.submap.num_keyframes = 20;
  Odometry odometry(options);
  std::vector<double> times;
  std::vector<int> pairs;
  // There and back again: forwards, then the same scans in reverse.
  std::int64_t stamp = 0;
  for (int k = 0; k < kNumScans; ++k) {
    const int period = 2 * simulation.frames - 2;
    const int phase = k % period;
    const bool forwards = phase < simulation.frames;
    RadarScan scan = drive.scans[static_cast<std::size_t>(forwards ? phase : period - phase)];
    // Every third return is enough here.
    std::vector<RadarReturn> thinned;
    for (std::size_t i = 0; i < scan.returns.size(); i += 3) thinned.push_back(scan.returns[i]);
    scan.returns = thinned;
    if (!forwards) {
      for (RadarReturn& entry : scan.returns) entry.doppler *= -1.0;
    }
    scan.stamp_ns = (stamp += 76923077);
    const OdometryResult result = odometry.AddScan(scan);
    times.push_back(result.times_ms.total);
    pairs.push_back(result.num_pairs);
  }
  const auto median = [](auto begin, auto end) {
    std::vector<double> sorted(begin, end);
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  };
  // Two whole periods are 1596 scans: the same places are compared.
  const double early = median(times.begin() + 798, times.begin() + 1596);
  const double late = median(times.end() - 798, times.end());
  std::cout << "median " << early << " ms early, " << late << " ms late\n";
  EXPECT_LT(late, 2.0 * early);
  const double pairs_early = median(pairs.begin() + 798, pairs.begin() + 1596);
  const double pairs_late = median(pairs.end() - 798, pairs.end());
  EXPECT_LT(pairs_late, 1.3 * pairs_early);
}

}  // namespace
}  // namespace radive
