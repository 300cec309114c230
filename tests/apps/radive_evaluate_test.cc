// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Runs the program itself. RADIVE_EVALUATE is its path, from CMake.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/shared_data.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Outcome {
  bool success = false;
  std::string output;  // both streams
};

Outcome RunEvaluate(const std::string& arguments) {
  const std::string command = "\"" RADIVE_EVALUATE "\" " + arguments + " 2>&1";
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return outcome;
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof(buffer), pipe)) > 0;) {
    outcome.output.append(buffer, n);
  }
  outcome.success = pclose(pipe) == 0;
  return outcome;
}

// The JSON object behind the warnings.
nlohmann::json JsonOf(const Outcome& outcome) {
  return nlohmann::json::parse(
      outcome.output.substr(std::min(outcome.output.find('{'), outcome.output.size())));
}

// Writes a TUM file that lives as long as the tests' temporary folder.
std::string WriteFile(const std::string& name, const std::string& text) {
  const std::string file = ::testing::TempDir() + "radive_evaluate_test_" + name;
  std::ofstream(file) << text;
  return file;
}

TEST(RadiveEvaluate, HelpShowsItsOwnFlagsOnly) {
  const Outcome help = RunEvaluate("--help");
  EXPECT_TRUE(help.success);
  for (const char* flag : {"--reference", "--estimate", "--max_time_difference", "--json"}) {
    EXPECT_THAT(help.output, HasSubstr(flag));
  }
  EXPECT_THAT(help.output, Not(HasSubstr("logtostderr")));
}

TEST(RadiveEvaluate, VersionIsOneLine) {
  const Outcome version = RunEvaluate("--version");
  EXPECT_TRUE(version.success);
  EXPECT_EQ(version.output, "radive_evaluate " RADIVE_VERSION "\n");
}

TEST(RadiveEvaluate, ComparesTwoFiles) {
  const std::string reference =
      WriteFile("ref.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 2 0 0 0 0 0 1\n");
  const std::string estimate = WriteFile("est.txt", "0 0 0 3 0 0 0 1\n1 1 4 0 0 0 0 1\n");
  const std::string files = "--reference=" + reference + " --estimate=" + estimate;
  const Outcome table = RunEvaluate(files);
  EXPECT_TRUE(table.success);
  EXPECT_THAT(table.output, HasSubstr("rmse         3.535533906 m\n"));  // sqrt((9 + 16) / 2)
  const Outcome json = RunEvaluate(files + " --json");
  ASSERT_TRUE(json.success) << json.output;
  EXPECT_EQ(JsonOf(json).at("sse").get<double>(), 25.0);
  EXPECT_EQ(JsonOf(json).at("matched").get<int>(), 2);
}

TEST(RadiveEvaluate, EveryFlagReachesTheEvaluation) {
  // A figure of nine poses; the estimate is 2 times too small and its stamps are 0.05 s late.
  std::string reference_text, estimate_text;
  for (int i = 0; i < 9; ++i) {
    const int x = i * i;
    const int y = i % 3;
    reference_text += std::to_string(i) + " " + std::to_string(2 * x) + " " +
                      std::to_string(2 * y) + " 0 0 0 0 1\n";
    estimate_text +=
        std::to_string(i) + ".05 " + std::to_string(x) + " " + std::to_string(y) + " 5 0 0 0 1\n";
  }
  const std::string files = "--reference=" + WriteFile("flags_ref.txt", reference_text) +
                            " --estimate=" + WriteFile("flags_est.txt", estimate_text);
  EXPECT_FALSE(RunEvaluate(files).success);  // the stamps are too far apart
  const Outcome ape =
      RunEvaluate(files + " --json --max_time_difference=0.06 --align=sim3 --align_first=6");
  ASSERT_TRUE(ape.success) << ape.output;
  EXPECT_NEAR(JsonOf(ape).at("max").get<double>(), 0.0, 1e-9);

  // Positions (x, y) = (0,0) (1,1) (4,2): on the reference steps are twice as long. Five frames
  // apart, all pairs: 4 errors; pairs from the reference make no difference in frames.
  const Outcome rpe =
      RunEvaluate(files +
                  " --json --max_time_difference=0.06 --plane=xz --metric=rpe --delta=5 "
                  "--delta_unit=f --all_pairs --relation=point_distance");
  ASSERT_TRUE(rpe.success) << rpe.output;
  const nlohmann::json json = JsonOf(rpe);
  EXPECT_EQ(json.at("count").get<int>(), 4);
  // In x alone, (i + 5)^2 - i^2 = 10 i + 25 is missing: 25, 35, 45, 55 m.
  EXPECT_EQ(json.at("min").get<double>(), 25.0);
  EXPECT_EQ(json.at("mean").get<double>(), 40.0);

  // 60 m of path: walking the reference gives other pairs than walking the estimate.
  const std::string metres = files + " --json --max_time_difference=0.06 --metric=rpe --delta=16 " +
                             "--delta_unit=m --relation=point_distance_ratio";
  const Outcome on_estimate = RunEvaluate(metres);
  const Outcome on_reference = RunEvaluate(metres + " --pairs_from_reference");
  ASSERT_TRUE(on_estimate.success) << on_estimate.output;
  ASSERT_TRUE(on_reference.success) << on_reference.output;
  EXPECT_NEAR(JsonOf(on_estimate).at("mean").get<double>(), 50.0, 1e-9);
  EXPECT_LT(JsonOf(on_estimate).at("count").get<int>(),
            JsonOf(on_reference).at("count").get<int>());
}

TEST(RadiveEvaluate, SaysWhatIsWrong) {
  const std::string good = WriteFile("good.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n");
  const std::string bad = WriteFile("bad.txt", "0 0 0 0 0 0 0 1\n1 1 0 0\n");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "--reference and --estimate are required"},
      {"--reference=" + good + " --estimate=/nowhere/e.txt", "/nowhere/e.txt: cannot be opened"},
      {"--reference=" + good + " --estimate=" + bad,
       "bad.txt:1: lines with different numbers of columns"},
      {"--reference=" + good + " --estimate=" + good + " --metric=ate", "one of ape | rpe"},
      {"--reference=" + good + " --estimate=" + good + " --align=se3", "two directions of motion"},
      {"--reference=" + good + " --estimate=" + good + " --delta=x --metric=rpe", "delta"},
      {"--reference=" + good + " --estimate=" + good + " --no_such_flag", "no_such_flag"},
      {good + " " + good, "unexpected argument"},
  };
  for (const auto& [arguments, message] : cases) {
    const Outcome outcome = RunEvaluate(arguments);
    EXPECT_FALSE(outcome.success) << arguments;
    EXPECT_THAT(outcome.output, HasSubstr(message));
  }
}

TEST(RadiveEvaluate, WarnsOfWhatIsOdd) {
  const std::string reference = WriteFile(
      "odd_ref.txt", "0 0 0 0 0 0 0 1.1\n1 1 0 0 0 0 0 1\n3 3 0 0 0 0 0 1\n4 4 0 0 0 0 0 1\n");
  const std::string estimate = WriteFile(
      "odd_est.txt", "0 0 0 0 0 0 0 1\n1 1 0 0 0 0 0 1\n2 2 0 0 0 0 0 1\n3 3 0 0 0 0 0 1\n");
  const Outcome outcome =
      RunEvaluate("--json --reference=" + reference + " --estimate=" + estimate);
  ASSERT_TRUE(outcome.success) << outcome.output;
  const nlohmann::json warnings = JsonOf(outcome).at("warnings");
  ASSERT_EQ(warnings.size(), 2u) << warnings;
  EXPECT_THAT(warnings[0].get<std::string>(),
              HasSubstr("odd_ref.txt: 1 of 4 poses have a quaternion whose length"));
  EXPECT_EQ(warnings[1],
            "1 of 4 poses of the estimate have no counterpart in the reference, in the time that "
            "it covers");
  EXPECT_THAT(outcome.output, HasSubstr("radive_evaluate: warning: 1 of 4 poses of the estimate"));
}

// Records of evo, one of each format, through the program.
TEST(RadiveEvaluate, ReproducesEvo) {
  RADIVE_SKIP_WITHOUT("trajectories/expected.json");
  const std::filesystem::path folder = testing::SharedData() / "trajectories";
  const nlohmann::json expected = nlohmann::json::parse(std::ifstream(folder / "expected.json"));
  struct Case {
    std::string name;
    std::string flags;
    nlohmann::json match;  // the record has these values
  };
  const std::vector<Case> cases = {
      {"kitti_00_orb",
       "--align=se3 --plane=xz --relation=angle_deg",
       {{"align", "se3"}, {"project", "xz"}, {"pose_relation", "angle_deg"}}},
      {"euroc_v102",
       "--align=sim3",
       {{"align", "sim3"}, {"project", nullptr}, {"pose_relation", "trans_part"}}},
      {"synthetic_car",
       "--align=se3 --align_first=100 --relation=full",
       {{"align", "se3_n100"}, {"project", nullptr}, {"pose_relation", "full"}}},
      {"synthetic_car_maxdiff_0.03",
       "--max_time_difference=0.03 --metric=rpe --delta=100 --delta_unit=m --all_pairs "
       "--pairs_from_reference --plane=xy",
       {{"delta", 100},
        {"unit", "m"},
        {"all_pairs", true},
        {"pairs_from_reference", true},
        {"project", "xy"},
        {"pose_relation", "trans_part"}}},
  };
  for (const Case& test : cases) {
    const nlohmann::json& recorded_case = expected.at("cases").at(test.name);
    const nlohmann::json& records = recorded_case.at(test.match.contains("delta") ? "rpe" : "ape");
    const auto record = std::find_if(records.begin(), records.end(), [&](const auto& candidate) {
      return std::all_of(
          test.match.items().begin(), test.match.items().end(), [&](const auto& item) {
            return candidate.at(item.key()) == item.value();
          });
    });
    ASSERT_TRUE(record != records.end()) << test.name;
    const Outcome outcome = RunEvaluate(
        "--json --format=" + recorded_case.at("format").get<std::string>() + " --reference=\"" +
        (folder / recorded_case.at("ref").get<std::string>()).string() + "\" --estimate=\"" +
        (folder / recorded_case.at("est").get<std::string>()).string() + "\" " + test.flags);
    ASSERT_TRUE(outcome.success) << outcome.output;
    const nlohmann::json actual = JsonOf(outcome);
    EXPECT_EQ(actual.at("matched"), recorded_case.at("num_matched")) << test.name;
    EXPECT_EQ(actual.at("count"), record->at("n")) << test.name;
    for (const auto& [statistic, value] : record->at("stats").items()) {
      const double tolerance = 1e-6 * std::max(1.0, std::abs(value.get<double>()));
      EXPECT_NEAR(actual.at(statistic).get<double>(), value.get<double>(), tolerance)
          << test.name << " " << statistic;
    }
  }
}

}  // namespace
}  // namespace radive
