// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/evaluate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "radive/evaluation/evaluation_report.h"
#include "tests/evaluation/evaluation_test_utils.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::StampedAlongX;

TEST(EvaluationOptions, DefaultsAreValidAndEvos) {
  std::string error;
  const EvaluationOptions options;
  EXPECT_TRUE(options.IsValid(&error)) << error;
  EXPECT_EQ(options.Word("metric"), "ape");
  EXPECT_EQ(options.Word("relation"), "trans_part");
  EXPECT_EQ(options.Word("align"), "none");
  EXPECT_EQ(options.Word("delta_unit"), "f");
}

TEST(EvaluationOptions, WordsSetTheirField) {
  std::string error;
  EvaluationOptions options;
  ASSERT_TRUE(options.SetWord("relation", "angle_deg", &error)) << error;
  EXPECT_EQ(options.relation, PoseRelation::kAngleDeg);
  ASSERT_TRUE(options.SetWord("delta_unit", "m", &error)) << error;
  EXPECT_EQ(options.pairs.delta_unit, DeltaUnit::kMetres);
  ASSERT_TRUE(options.SetWord("plane", "yz", &error)) << error;
  EXPECT_EQ(options.plane, Plane::kYz);
}

TEST(EvaluationOptions, OtherWordsAreErrorsThatListTheRightOnes) {
  std::string error;
  EvaluationOptions options;
  EXPECT_FALSE(options.SetWord("metric", "ate", &error));
  EXPECT_EQ(error, "metric must be one of ape | rpe | segments, is 'ate'");
  EXPECT_EQ(options.metric, EvaluationMetric::kApe);
}

TEST(EvaluationOptions, RangesAreChecked) {
  std::string error;
  EvaluationOptions options;
  options.max_time_difference = -1.0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_THAT(error, HasSubstr("max_time_difference must be >= 0"));
  options.max_time_difference = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(options.IsValid(&error));
  options = EvaluationOptions();
  options.align_first = 10;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_THAT(error, HasSubstr("align_first needs align se3"));
  options.align = AlignmentMode::kSe3;
  EXPECT_TRUE(options.IsValid(&error)) << error;
}

// Reference x = t at 0, 1, 2, 3 s; the estimate has the same poses 0.1 m too high and 0.2 m apart
// in x at every second pose, and one pose of another time.
RecordedTrajectory StampedEstimate() {
  RecordedTrajectory estimate = StampedAlongX({0.0, 1.0, 2.0, 7.0});
  for (RecordedPose& pose : estimate) pose.T_world_body.translation.z() = 0.1;
  estimate[1].T_world_body.translation.x() += 0.2;
  return estimate;
}

TEST(Evaluate, MatchesProjectsAndMeasures) {
  std::string error;
  EvaluationOptions options;
  options.plane = Plane::kXy;
  const auto result = Evaluate(StampedAlongX({0, 1, 2, 3}), StampedEstimate(), options, &error);
  ASSERT_TRUE(result) << error;
  EXPECT_EQ(result->num_matched, 3);
  EXPECT_EQ(result->unit, "m");
  ASSERT_EQ(result->errors.size(), 3u);
  EXPECT_EQ(result->errors[0], 0.0);
  EXPECT_NEAR(result->errors[1], 0.2, 1e-12);
  EXPECT_NEAR(result->statistics.sse, 0.04, 1e-12);
}

TEST(Evaluate, RelativeErrorsTakePairsFromTheEstimateUnlessTold) {
  // Along the estimate poses 1 and 2 are 2 m and 4 m on, along the reference 1 m and 2 m.
  RecordedTrajectory estimate = StampedAlongX({0.0, 1.0, 2.0});
  for (RecordedPose& pose : estimate) pose.T_world_body.translation *= 2.0;
  EvaluationOptions options;
  options.metric = EvaluationMetric::kRpe;
  options.pairs = {2.0, DeltaUnit::kMetres, /*all_pairs=*/true};
  std::string error;
  const auto on_estimate = Evaluate(StampedAlongX({0, 1, 2}), estimate, options, &error);
  ASSERT_TRUE(on_estimate) << error;
  EXPECT_EQ(on_estimate->errors, (std::vector<double>{1.0, 1.0}));
  options.pairs_from_reference = true;
  const auto on_reference = Evaluate(StampedAlongX({0, 1, 2}), estimate, options, &error);
  ASSERT_TRUE(on_reference) << error;
  EXPECT_EQ(on_reference->errors, (std::vector<double>{2.0}));
}

// 6 m, and the same in millimetres; half or twice as long is an error of the odometry.
TEST(Evaluate, WarnsOfPathsOfOtherUnits) {
  const RecordedTrajectory reference = StampedAlongX({0.0, 2.0, 4.0, 6.0});
  for (const double scale : {1.0, 0.5, 2.0, 1000.0}) {
    RecordedTrajectory estimate = reference;
    for (RecordedPose& pose : estimate) pose.T_world_body.translation *= scale;
    std::string error;
    const auto result = Evaluate(reference, estimate, EvaluationOptions(), &error);
    ASSERT_TRUE(result) << error;
    EXPECT_EQ(result->warnings.size(), scale == 1000.0 ? 1u : 0u);
    if (scale != 1000.0) continue;
    EXPECT_THAT(result->warnings.at(0),
                HasSubstr("estimate is 6000 m long, that of the reference 6 m"));
  }
}

TEST(Evaluate, HandsErrorsOn) {
  std::string error;
  EvaluationOptions options;
  EXPECT_FALSE(Evaluate(StampedAlongX({0, 1}), StampedAlongX({5}), options, &error));
  EXPECT_THAT(error, HasSubstr("no stamps"));
  // Too few matches, and no motion, to align.
  options.align = AlignmentMode::kSe3;
  EXPECT_FALSE(Evaluate(StampedAlongX({0, 1, 2}), StampedAlongX({1}), options, &error));
  EXPECT_THAT(error, HasSubstr("at least two directions of motion"));
  RecordedTrajectory standing = StampedAlongX({0, 1, 2});
  for (RecordedPose& pose : standing) pose.T_world_body.translation.setConstant(5e6);
  EXPECT_FALSE(Evaluate(standing, standing, options, &error));
  EXPECT_THAT(error, HasSubstr("the 3 matched positions"));

  options = EvaluationOptions();
  options.metric = EvaluationMetric::kSegments;
  EXPECT_FALSE(Evaluate(standing, standing, options, &error));
  EXPECT_THAT(error, HasSubstr("more than 100 m"));
  options.metric = EvaluationMetric::kRpe;
  options.pairs.delta_unit = DeltaUnit::kMetres;
  EXPECT_FALSE(Evaluate(standing, standing, options, &error));
  EXPECT_THAT(error, HasSubstr("no two of the 3 matched poses"));
  options.pairs.delta = 0.0;
  EXPECT_FALSE(Evaluate(standing, standing, options, &error));
  EXPECT_THAT(error, HasSubstr("delta must be > 0"));
}

TEST(EvaluationReport, JsonHoldsEveryFigureExactly) {
  std::string error;
  const EvaluationOptions options;
  const auto result = Evaluate(StampedAlongX({0, 1, 2, 3}), StampedEstimate(), options, &error);
  ASSERT_TRUE(result) << error;
  const nlohmann::json json = nlohmann::json::parse(EvaluationJson(*result, options));
  EXPECT_EQ(json.at("rmse").get<double>(), result->statistics.rmse);
  EXPECT_EQ(json.at("mean").get<double>(), result->statistics.mean);
  EXPECT_EQ(json.at("median").get<double>(), result->statistics.median);
  EXPECT_EQ(json.at("std").get<double>(), result->statistics.std);
  EXPECT_EQ(json.at("min").get<double>(), result->statistics.min);
  EXPECT_EQ(json.at("max").get<double>(), result->statistics.max);
  EXPECT_EQ(json.at("sse").get<double>(), result->statistics.sse);
  EXPECT_EQ(json.at("matched").get<int>(), 3);
  EXPECT_EQ(json.at("unit").get<std::string>(), "m");
}

TEST(EvaluationReport, TableHasUnits) {
  std::string error;
  EvaluationOptions options;
  options.relation = PoseRelation::kAngleDeg;
  const auto result = Evaluate(StampedAlongX({0, 1, 2, 3}), StampedEstimate(), options, &error);
  ASSERT_TRUE(result) << error;
  const std::string table = EvaluationTable(*result, options);
  EXPECT_THAT(table, HasSubstr("Absolute pose error, angle_deg; align none\n"));
  EXPECT_THAT(table, HasSubstr("3 matched poses, of 4 in the reference and 4 in the estimate\n"));
  EXPECT_THAT(table, HasSubstr("rmse         0.000000000 deg\n"));
}

TEST(EvaluationReport, SegmentsByLength) {
  // 250 m in steps of 5 m, the estimate 2 % too long.
  std::vector<double> stamps;
  for (int i = 0; i <= 50; ++i) stamps.push_back(5.0 * i);
  RecordedTrajectory estimate = StampedAlongX(stamps);
  for (RecordedPose& pose : estimate) pose.T_world_body.translation *= 1.02;
  EvaluationOptions options;
  options.metric = EvaluationMetric::kSegments;
  std::string error;
  const auto result = Evaluate(StampedAlongX(stamps), estimate, options, &error);
  ASSERT_TRUE(result) << error;
  // 100 m: starts at 0, 50, 100 m, each 105 m long, so 2.1 %. 200 m: start at 0, 205 m, 2.05 %.
  ASSERT_EQ(result->errors.size(), 4u);
  EXPECT_NEAR(result->statistics.mean, (3 * 2.1 + 2.05) / 4, 1e-9);
  const std::string table = EvaluationTable(*result, options);
  EXPECT_THAT(table, HasSubstr("         100         3         2.100000        0.00000000\n"));
  EXPECT_THAT(table, HasSubstr("         200         1         2.050000        0.00000000\n"));
  EXPECT_THAT(table, HasSubstr("         all         4         2.087500        0.00000000\n"));
  const nlohmann::json json = nlohmann::json::parse(EvaluationJson(*result, options));
  EXPECT_NEAR(json.at("mean_translation_percent").get<double>(), 2.0875, 1e-9);
  EXPECT_NEAR(json.at("mean_rotation_deg_per_m").get<double>(), 0.0, 1e-12);
}

}  // namespace
}  // namespace radive
