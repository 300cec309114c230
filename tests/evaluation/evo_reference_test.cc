// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Every figure that evo itself computed for the reference trajectory pairs, and the KITTI segment
// errors recorded beside them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "radive/evaluation/evaluate.h"
#include "radive/io/trajectories/trajectory_io.h"
#include "radive/util/angle_units.h"
#include "tests/shared_data.h"

namespace radive {
namespace {

using nlohmann::json;

std::filesystem::path Folder() { return testing::SharedData() / "trajectories"; }

json ReadExpected() { return json::parse(std::ifstream(Folder() / "expected.json")); }

// How far `actual` is off, in units of the tolerance promised: 1e-6, relative above 1.
double Deviation(double actual, double expected) {
  return std::abs(actual - expected) / std::max(1.0, std::abs(expected)) / 1e-6;
}

struct TrajectoryPair {
  RecordedTrajectory reference;
  RecordedTrajectory estimate;
};

TrajectoryFormat FormatOf(const json& recorded_case) {
  const std::string name = recorded_case.at("format");
  if (name == "tum") return TrajectoryFormat::kTum;
  EXPECT_TRUE(name == "kitti" || name == "euroc") << name;
  return name == "kitti" ? TrajectoryFormat::kKitti : TrajectoryFormat::kEuroc;
}

EvaluationOptions OptionsOf(const json& recorded_case) {
  EvaluationOptions options;
  if (FormatOf(recorded_case) == TrajectoryFormat::kKitti) options.match = PoseMatch::kLine;
  if (recorded_case.at("t_max_diff").is_number()) {
    options.max_time_difference = recorded_case.at("t_max_diff");
  }
  return options;
}

TrajectoryPair ReadPair(const json& recorded_case) {
  const TrajectoryFormat format = FormatOf(recorded_case);
  std::string error;
  const auto reference =
      ReadTrajectory(Folder() / recorded_case.at("ref").get<std::string>(), format, &error);
  const auto estimate =
      ReadTrajectory(Folder() / recorded_case.at("est").get<std::string>(),
                     format == TrajectoryFormat::kEuroc ? TrajectoryFormat::kTum : format,
                     &error);
  EXPECT_TRUE(reference && estimate) << error;
  if (!reference || !estimate) return {};
  return {*reference, *estimate};
}

void SetAlignment(const std::string& recorded, EvaluationOptions* options) {
  std::string error;
  const bool first_hundred = recorded == "se3_n100";
  if (first_hundred) options->align_first = 100;
  EXPECT_TRUE(options->SetWord("align", first_hundred ? "se3" : recorded, &error)) << error;
}

// The options that an "ape" or "rpe" record stands for.
EvaluationOptions OptionsOf(const json& recorded_case, const json& record, bool relative) {
  EvaluationOptions options = OptionsOf(recorded_case);
  std::string error;
  SetAlignment(record.at("align"), &options);
  EXPECT_TRUE(options.SetWord("relation", record.at("pose_relation"), &error)) << error;
  if (record.at("project").is_string()) {
    EXPECT_TRUE(options.SetWord("plane", record.at("project"), &error)) << error;
  }
  if (!relative) return options;
  options.metric = EvaluationMetric::kRpe;
  options.pairs.delta = record.at("delta");
  options.pairs.all_pairs = record.at("all_pairs");
  options.pairs_from_reference = record.at("pairs_from_reference");
  const std::string unit = record.at("unit");
  EXPECT_TRUE(options.SetWord("delta_unit", unit == "frames" ? "f" : unit, &error)) << error;
  return options;
}

// Checks all records of one kind in all cases; returns their number.
int CheckRecords(const std::string& kind) {
  int num_records = 0;
  double worst = 0.0;
  const json cases = ReadExpected().at("cases");
  for (const auto& [name, recorded_case] : cases.items()) {
    const TrajectoryPair pair = ReadPair(recorded_case);
    EXPECT_EQ(pair.reference.size(), recorded_case.at("num_ref").get<std::size_t>()) << name;
    EXPECT_EQ(pair.estimate.size(), recorded_case.at("num_est").get<std::size_t>()) << name;
    for (const json& record : recorded_case.at(kind)) {
      ++num_records;
      json description = record;
      description.erase("stats");
      const std::string where = name + " " + description.dump();
      std::string error;
      const auto result = Evaluate(
          pair.reference, pair.estimate, OptionsOf(recorded_case, record, kind == "rpe"), &error);
      EXPECT_TRUE(result) << where << ": " << error;
      if (!result) continue;
      EXPECT_EQ(result->num_matched, recorded_case.at("num_matched").get<int>()) << where;
      EXPECT_EQ(result->statistics.count, record.at("n").get<int>()) << where;
      const ErrorStatistics& s = result->statistics;
      const std::map<std::string, double> actual = {{"rmse", s.rmse},
                                                    {"mean", s.mean},
                                                    {"median", s.median},
                                                    {"std", s.std},
                                                    {"min", s.min},
                                                    {"max", s.max},
                                                    {"sse", s.sse}};
      for (const auto& [statistic, value] : actual) {
        const double deviation = Deviation(value, record.at("stats").at(statistic));
        worst = std::max(worst, deviation);
        EXPECT_LT(deviation, 1.0) << where << " " << statistic << " is " << value;
      }
    }
  }
  std::printf(
      "%d %s records, worst relative difference %.2g\n", num_records, kind.c_str(), worst * 1e-6);
  return num_records;
}

TEST(EvoReference, EveryAbsolutePoseError) {
  RADIVE_SKIP_WITHOUT("trajectories/expected.json");
  EXPECT_EQ(CheckRecords("ape"), 352);
}

TEST(EvoReference, EveryRelativePoseError) {
  RADIVE_SKIP_WITHOUT("trajectories/expected.json");
  EXPECT_EQ(CheckRecords("rpe"), 576);
}

TEST(EvoReference, EveryAlignment) {
  RADIVE_SKIP_WITHOUT("trajectories/expected.json");
  const json cases = ReadExpected().at("cases");
  for (const auto& [name, recorded_case] : cases.items()) {
    const TrajectoryPair pair = ReadPair(recorded_case);
    for (const auto& [mode, matrix] : recorded_case.at("alignment").items()) {
      EvaluationOptions options = OptionsOf(recorded_case);
      // For scale_only evo reports the whole similarity of which it then applies the scale.
      SetAlignment(mode == "scale_only" ? "sim3" : mode, &options);
      std::string error;
      const auto result = Evaluate(pair.reference, pair.estimate, options, &error);
      ASSERT_TRUE(result) << name << " " << mode << ": " << error;
      Eigen::Matrix<double, 3, 4> rows;
      rows << result->alignment.scale * result->alignment.rotation, result->alignment.translation;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 4; ++c) {
          EXPECT_LT(Deviation(rows(r, c), matrix.at(r).at(c)), 1.0) << name << " " << mode;
        }
      }
    }
  }
}

TEST(EvoReference, EveryKittiSegment) {
  RADIVE_SKIP_WITHOUT("trajectories/expected.json");
  int num_records = 0;
  const json cases = ReadExpected().at("cases");
  for (const auto& [name, recorded_case] : cases.items()) {
    if (!recorded_case.contains("kitti_segments")) continue;
    const TrajectoryPair pair = ReadPair(recorded_case);
    const EvaluationOptions options = OptionsOf(recorded_case);
    std::string error;
    const auto poses =
        options.match == PoseMatch::kLine
            ? AssociateByIndex(pair.reference, pair.estimate, &error)
            : AssociateByStamp(pair.reference, pair.estimate, options.max_time_difference, &error);
    ASSERT_TRUE(poses) << error;
    for (const auto& [key, record] : recorded_case.at("kitti_segments").items()) {
      const int step = std::stoi(key.substr(std::string("step_").size()));
      const auto drift = ComputeSegmentDrift(*poses, step, &error);
      ASSERT_TRUE(drift) << error;
      const std::string where = name + " " + key;
      EXPECT_EQ(drift->segments.size(), record.at("n").get<std::size_t>()) << where;
      EXPECT_LT(Deviation(100.0 * drift->translation, record.at("t_err_percent")), 1.0) << where;
      EXPECT_LT(Deviation(Degrees(drift->rotation), record.at("r_err_deg_per_m")), 1.0) << where;
      for (const auto& [length, of_length] : record.at("per_length").items()) {
        std::size_t count = 0;
        double translation = 0.0;
        double rotation = 0.0;
        for (const SegmentError& segment : drift->segments) {
          if (segment.length != std::stod(length)) continue;
          ++count;
          translation += segment.translation;
          rotation += segment.rotation;
        }
        const double n = static_cast<double>(count);
        EXPECT_EQ(count, of_length.at("n").get<std::size_t>()) << where << " " << length;
        EXPECT_LT(Deviation(100.0 * translation / n, of_length.at("t_err_percent")), 1.0) << where;
        EXPECT_LT(Deviation(Degrees(rotation / n), of_length.at("r_err_deg_per_m")), 1.0) << where;
      }
      ++num_records;
    }
  }
  EXPECT_EQ(num_records, 6);
}

}  // namespace
}  // namespace radive
