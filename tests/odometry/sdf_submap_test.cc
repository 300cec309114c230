// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/sdf_submap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/simulated_drive.h"

namespace radive {
namespace {

using testing::Compare;
using testing::Drive;
using testing::DriveErrors;
using testing::OptionsFor;
using testing::RunOdometry;
using testing::Scenario;
using testing::SimulateDrive;

// A wall across the road 10 m ahead, returns `spacing` apart, seen from `x`.
Keyframe WallKeyframe(double x, double spacing) {
  Keyframe keyframe;
  keyframe.T_world_radar.translation.x() = x;
  for (double y = -4.0; y <= 4.0; y += spacing) {
    for (double z = -1.0; z <= 1.0; z += spacing) {
      RadarReturn entry;
      entry.position = {10.0 - x, y, z};
      keyframe.returns.push_back(entry);
    }
  }
  keyframe.weights.assign(keyframe.returns.size(), 1.0);
  return keyframe;
}

OdometryOptions SdfOptions() {
  OdometryOptions options;
  options.submap.type = SubmapOptions::Type::kSdf;
  options.sdf_submap.bypass_keyframes = 2;
  options.sdf_submap.handover_scans = 2;
  options.surface.projection = 0.0;
  options.surface.trial_keyframes = 0;
  return options;
}

std::size_t SizeOf(const Submap& submap) { return submap.search()->submap().size(); }

TEST(SdfSubmap, HandsOverByScanIndex) {
  for (const int num_threads : {1, 2}) {
    OdometryOptions options = SdfOptions();
    options.num_threads = num_threads;
    const auto submap = MakeSubmap(options);
    EXPECT_EQ(submap->search(), nullptr);
    submap->AddKeyframe(WallKeyframe(0.0, 0.25));
    const std::size_t num_raw = WallKeyframe(0.0, 0.25).returns.size();
    EXPECT_EQ(SizeOf(*submap), num_raw) << "raw at first";
    for (int i = 0; i < 3; ++i) submap->NextScan();
    EXPECT_EQ(SizeOf(*submap), num_raw) << "still undecided";
    submap->AddKeyframe(WallKeyframe(1.0, 0.25));
    EXPECT_EQ(SizeOf(*submap), 2 * num_raw);
    submap->NextScan();
    submap->NextScan();
    EXPECT_EQ(SizeOf(*submap), 2 * num_raw) << "two scans are for the training";
    EXPECT_TRUE(submap->TakeNotes().empty());
    submap->NextScan();
    EXPECT_LT(SizeOf(*submap), num_raw) << "one neural point for four returns";
    EXPECT_GT(SizeOf(*submap), num_raw / 8);
    const auto notes = submap->TakeNotes();
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("extracted surface"), std::string::npos) << notes[0];
    for (const Gaussian3& gaussian : submap->search()->submap()) {
      EXPECT_NEAR(gaussian.mean.x(), 10.0, 1e-9);
    }
    submap->Clear();
    EXPECT_EQ(submap->search(), nullptr);
    submap->AddKeyframe(WallKeyframe(0.0, 0.25));
    EXPECT_EQ(SizeOf(*submap), num_raw);
  }
}

// The walls of three keyframes, on one thread and on two, as they are after the last of them.
TEST(SdfSubmap, RecordsTheSurfaceOnlyWhenAskedTo) {
  std::vector<std::vector<SurfacePoint>> surfaces;
  for (const int num_threads : {0, 1, 2}) {
    OdometryOptions options = SdfOptions();
    options.num_threads = std::max(1, num_threads);
    options.sdf_submap.record = num_threads > 0;
    const auto submap = MakeSubmap(options);
    for (int k = 0; k < 3; ++k) submap->AddKeyframe(WallKeyframe(k, 0.25));
    const std::optional<SurfaceRecord> record = submap->TakeSurfaceRecord();
    ASSERT_EQ(record.has_value(), num_threads > 0);
    if (record) surfaces.push_back(SelectSurface(record->points(), options.surface));
    EXPECT_FALSE(submap->TakeSurfaceRecord().has_value()) << "taken";
  }
  ASSERT_EQ(surfaces[0].size(), surfaces[1].size());
  EXPECT_GT(surfaces[0].size(), 40u);
  for (std::size_t i = 0; i < surfaces[0].size(); ++i) {
    EXPECT_NEAR(surfaces[0][i].position.x(), 10.0, 1e-9);
    EXPECT_EQ(surfaces[0][i].sdf, surfaces[1][i].sdf);
  }
}

TEST(SdfSubmap, SparseSensorsStayRaw) {
  OdometryOptions options = SdfOptions();
  options.sdf_submap.record = true;
  const auto submap = MakeSubmap(options);
  const std::size_t num_raw = WallKeyframe(0.0, 2.0).returns.size();
  for (int k = 0; k < 4; ++k) {
    submap->AddKeyframe(WallKeyframe(0.0, 2.0));
    for (int i = 0; i < 3; ++i) submap->NextScan();
  }
  EXPECT_EQ(SizeOf(*submap), 4 * num_raw);
  const auto notes = submap->TakeNotes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("bypassed"), std::string::npos) << notes[0];
  EXPECT_NE(notes[0].find("1 neighbours"), std::string::npos) << notes[0];
  EXPECT_FALSE(submap->TakeSurfaceRecord().has_value());
}

// From the first keyframe on, and even where the surface is nothing at all.
TEST(SdfSubmap, WithoutBypassTheSubmapIsTheSurfaceAlone) {
  OdometryOptions options = SdfOptions();
  options.sdf_submap.bypass = false;
  options.sdf_submap.handover_scans = 0;
  const auto submap = MakeSubmap(options);
  EXPECT_EQ(submap->search(), nullptr);
  submap->AddKeyframe(WallKeyframe(0.0, 0.25));
  ASSERT_NE(submap->search(), nullptr);
  const std::size_t num_surface = SizeOf(*submap);
  EXPECT_LT(num_surface, WallKeyframe(0.0, 0.25).returns.size()) << "neural points, not returns";
  EXPECT_GT(num_surface, 0u);
  submap->Clear();
  EXPECT_EQ(submap->search(), nullptr);

  options.surface.min_support = 1e9;
  const auto empty = MakeSubmap(options);
  for (int k = 0; k < 7; ++k) empty->AddKeyframe(WallKeyframe(0.0, 2.0));
  ASSERT_NE(empty->search(), nullptr);
  EXPECT_EQ(SizeOf(*empty), 0u);
  EXPECT_TRUE(empty->TakeNotes().empty());
}

TEST(SdfSubmap, ReturnsOfSurfaceCells) {
  OdometryOptions options = SdfOptions();
  options.sdf_submap.source = SdfSubmapOptions::Source::kReturns;
  options.sdf_submap.handover_scans = 0;
  options.surface.min_support = 1.5;
  options.sdf_submap.flatten = 0.0;
  const auto submap = MakeSubmap(options);
  for (int k = 0; k < 3; ++k) {
    Keyframe keyframe = WallKeyframe(0.0, 0.25);
    if (k == 1) {  // a ghost
      RadarReturn ghost;
      ghost.position = {20.0, 0.0, 0.0};
      keyframe.returns.push_back(ghost);
      keyframe.weights.push_back(1.0);
    }
    submap->AddKeyframe(std::move(keyframe));
  }
  EXPECT_EQ(SizeOf(*submap), 3 * WallKeyframe(0.0, 0.25).returns.size());
  // Flattened along the normal: thinner towards the radar than the raw Gaussian of the same return.
  options.sdf_submap.flatten = 1.0;
  const auto flat = MakeSubmap(options);
  for (int k = 0; k < 3; ++k) flat->AddKeyframe(WallKeyframe(0.0, 0.25));
  const double thickness = flat->search()->submap()[0].covariance(0, 0);
  EXPECT_LT(thickness, 0.5 * submap->search()->submap()[0].covariance(0, 0) + options.ndt.epsilon);
  EXPECT_GE(thickness, options.ndt.epsilon);
}

// The whole odometry: the same bytes with one thread and with two, and as good as it should be.
TEST(SdfSubmap, DenseDriveIsAccurateAndTheSameWithTwoThreads) {
  SimulationOptions simulation = Scenario("street_dense", 40);
  simulation.rate = 6.0;
  const Drive drive = SimulateDrive(simulation);
  OdometryOptions options = OptionsFor(simulation);
  options.submap.type = SubmapOptions::Type::kSdf;
  const std::vector<OdometryResult> one = RunOdometry(options, drive.scans);
  options.num_threads = 2;
  const std::vector<OdometryResult> two = RunOdometry(options, drive.scans);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(ToPoseBlock(one[i].T_world_radar), ToPoseBlock(two[i].T_world_radar)) << i;
    EXPECT_EQ(one[i].cost, two[i].cost) << i;
  }
  const DriveErrors errors = Compare(drive, one);
  std::cout << errors.length << " m: rmse " << errors.rmse << " m\n";
  EXPECT_GT(errors.length, 20.0);
  EXPECT_LT(errors.rmse, 0.01 * errors.length);
}

}  // namespace
}  // namespace radive
