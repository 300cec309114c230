// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/run_scores.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "radive/io/trajectories/trajectory_io.h"
#include "radive/pipeline/run_sequence.h"
#include "tests/pipeline/fake_scan_source.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using testing::FakeScanSource;
using ::testing::HasSubstr;
using testing::ReadFile;
using testing::ScratchFolder;
using testing::StaticScans;

// A bend, so that an alignment is defined: pose k at (k, k^2 / 10).
Trajectory Bend(int count) {
  Trajectory poses;
  for (int k = 0; k < count; ++k) {
    const double x = k;
    poses.push_back({k * std::int64_t{100000000},
                     Rigid3(QuaternionFromRotationVector({0, 0, 0.2 * x}), {x, 0.1 * x * x, 0})});
  }
  return poses;
}

RunEstimate EstimateOf(const Trajectory& poses) {
  RunEstimate estimate;
  estimate.poses = ToRecordedTrajectory(poses);
  return estimate;
}

Reference ReferenceOf(const Trajectory& poses) {
  Reference reference;
  reference.poses = ToRecordedTrajectory(poses);
  reference.description = "a bend";
  return reference;
}

TEST(ScoreEstimate, BringsTheEstimateToTheBodyOfTheReference) {
  // The truth is of a body 2 m ahead of the radar and turned by 0.5 rad.
  const Rigid3 T_radar_reference(QuaternionFromRotationVector({0, 0, 0.5}), {2, 0, 0});
  Trajectory truth = Bend(10);
  for (StampedPose& pose : truth) pose.T_world_body = pose.T_world_body * T_radar_reference;
  RunEstimate estimate = EstimateOf(Bend(10));
  std::string error;
  auto scores = ScoreEstimate(estimate, ReferenceOf(truth), ReferenceOptions(), &error);
  ASSERT_TRUE(scores) << error;
  EXPECT_GT((*scores)[0].result.statistics.rmse, 0.1) << "compared as they are";
  estimate.T_output_reference = T_radar_reference;
  scores = ScoreEstimate(estimate, ReferenceOf(truth), ReferenceOptions(), &error);
  ASSERT_TRUE(scores) << error;
  ASSERT_EQ(scores->size(), 4u) << "10 m of path have no segments of 100 m";
  for (const RunScore& score : *scores) {
    EXPECT_NEAR(score.result.statistics.rmse, 0.0, 1e-9) << score.name;
  }
  EXPECT_EQ((*scores)[1].name, "ape_angle");
  EXPECT_EQ((*scores)[1].result.unit, "deg");
}

TEST(ScoreEstimate, WithoutStampsTakesTheLinesThatWereRunOver) {
  Reference reference = ReferenceOf(Bend(12));
  reference.has_stamps = false;
  const Trajectory all = Bend(12);
  RunEstimate estimate = EstimateOf(Trajectory(all.begin() + 3, all.begin() + 9));
  std::string error;
  EXPECT_FALSE(ScoreEstimate(estimate, reference, ReferenceOptions(), &error));
  EXPECT_THAT(error, HasSubstr("found 6 and 12"));
  estimate.start = 3;
  estimate.is_partial = true;
  const auto scores = ScoreEstimate(estimate, reference, ReferenceOptions(), &error);
  ASSERT_TRUE(scores) << error;
  EXPECT_EQ((*scores)[0].result.num_matched, 6);
  EXPECT_NEAR((*scores)[0].result.statistics.rmse, 0.0, 1e-9);
}

TEST(ScoreEstimate, PlacesAloneHaveNoAngles) {
  Reference reference = ReferenceOf(Bend(10));
  reference.has_rotations = false;
  std::string error;
  const auto scores = ScoreEstimate(EstimateOf(Bend(10)), reference, ReferenceOptions(), &error);
  ASSERT_TRUE(scores) << error;
  ASSERT_EQ(scores->size(), 2u);
  EXPECT_EQ((*scores)[1].name, "ape_trans_xy");
  EvaluationOptions options;
  options.relation = PoseRelation::kAngleDeg;
  RecordedTrajectory poses;
  EXPECT_FALSE(PrepareComparison(EstimateOf(Bend(10)), &reference, &poses, &options, &error));
  EXPECT_THAT(error, HasSubstr("places alone"));
}

TEST(RunSequence, WritesTheScoresThatTheFolderGivesAgain) {
  const ScratchFolder scratch;
  const std::filesystem::path truth = scratch.path() / "truth.txt";
  Trajectory poses;
  for (int k = 0; k < 12; ++k) {
    const double x = 0.8 * k;
    poses.push_back({k * std::int64_t{100000000},
                     Rigid3(Eigen::Quaterniond::Identity(), {x, 0.01 * x * x, 0})});
  }
  std::string error, text;
  ASSERT_TRUE(WriteTumTrajectory(truth, poses, &error)) << error;
  RunConfig config;
  config.odometry.sensor.mount_x = 2.0;
  config.output.frame = OutputOptions::Frame::kVehicle;
  config.reference.mount = {0, 0, 0.5, 0, 0, 0};
  RunRequest request;
  request.input = "somewhere";
  request.output = (scratch.path() / "run").string();
  request.reference = truth.string();
  request.quiet = true;
  request.num_frames = 9;
  FakeScanSource source(StaticScans(12, {8, 0, 0}, 1.0));
  ASSERT_EQ(RunSequence(config, request, &source, &error, &text), RunStatus::kDone) << error;
  EXPECT_THAT(text, HasSubstr("scores against 12 poses (tum, " + truth.string()));
  const auto json = nlohmann::json::parse(ReadFile(scratch.path() / "run" / "scores.json"));
  EXPECT_EQ(json.at("scores").at("ape_trans").at("matched"), 9);

  const auto estimate = ReadRunEstimate(scratch.path() / "run", &error);
  ASSERT_TRUE(estimate) << error;
  EXPECT_TRUE(estimate->is_partial);
  // From the rear axle to the radar, and up.
  EXPECT_NEAR(
      (estimate->T_output_reference.translation - Eigen::Vector3d(2, 0, 0.5)).norm(), 0.0, 1e-12);
  const auto reference = ReadReference(truth, config.reference, /*clip=*/0, &error);
  ASSERT_TRUE(reference) << error;
  const auto again = ScoreEstimate(*estimate, *reference, config.reference, &error);
  ASSERT_TRUE(again) << error;
  EXPECT_EQ((*again)[0].result.statistics.rmse,
            json.at("scores").at("ape_trans").at("rmse").get<double>());

  // Another run without ground truth leaves no scores of the earlier one.
  request.reference.clear();
  FakeScanSource other(StaticScans(12, {8, 0, 0}, 1.0));
  ASSERT_EQ(RunSequence(config, request, &other, &error, &text), RunStatus::kDone) << error;
  EXPECT_EQ(text, "");
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "run" / "scores.json"));

  request.reference = (scratch.path() / "absent").string();
  request.output = (scratch.path() / "none").string();
  EXPECT_EQ(RunSequence(config, request, &other, &error), RunStatus::kFailed);
  EXPECT_THAT(error, HasSubstr("absent: cannot be opened"));
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "none")) << "found out before the run";
}

}  // namespace
}  // namespace radive
