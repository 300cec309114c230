// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/run_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "radive/config/describe_config.h"
#include "radive/config/load_config.h"
#include "tests/pipeline/fake_scan_source.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using testing::FakeScanSource;
using ::testing::HasSubstr;
using testing::kForward;
using testing::ReadFile;
using testing::ScratchFolder;
using testing::StaticScans;

constexpr std::array<const char*, 7> kFiles = {"trajectory_tum.txt",
                                               "trajectory_kitti.txt",
                                               "scans.csv",
                                               "timing.csv",
                                               "map.ply",
                                               "config.yaml",
                                               "run.json"};

RunRequest RequestFor(const std::filesystem::path& folder) {
  RunRequest request;
  request.input = "somewhere";
  request.output = folder.string();
  request.quiet = true;
  request.command_line = "radive_odometry --input somewhere";
  request.version = "1.2.3";
  return request;
}

int CountLines(const std::filesystem::path& path) {
  const std::string text = ReadFile(path);
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

nlohmann::json RunJson(const std::filesystem::path& folder) {
  return nlohmann::json::parse(ReadFile(folder / "run.json"));
}

TEST(RunSequence, WritesALineForEachScanAndAllFiles) {
  const ScratchFolder scratch;
  FakeScanSource source(StaticScans(12, kForward, 1.0));
  source.Warn("FILE: 3 bytes too many");
  std::string error;
  ASSERT_EQ(RunSequence(RunConfig(), RequestFor(scratch.path()), &source, &error), RunStatus::kDone)
      << error;
  int num_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) {
    EXPECT_THAT(kFiles, ::testing::Contains(entry.path().filename().string()));
    ++num_files;
  }
  EXPECT_EQ(num_files, 7);
  EXPECT_EQ(CountLines(scratch.path() / "trajectory_tum.txt"), 12);
  EXPECT_EQ(CountLines(scratch.path() / "trajectory_kitti.txt"), 12);
  EXPECT_EQ(CountLines(scratch.path() / "scans.csv"), 13);
  EXPECT_EQ(CountLines(scratch.path() / "timing.csv"), 13);

  const nlohmann::json run = RunJson(scratch.path());
  EXPECT_EQ(run["frames"], 12);
  EXPECT_EQ(run["version"], "1.2.3");
  EXPECT_EQ(run["command_line"], "radive_odometry --input somewhere");
  EXPECT_EQ(run["input"], "somewhere");
  EXPECT_EQ(run["source"], "made-up scans");
  EXPECT_EQ(run["interrupted"], false);
  EXPECT_EQ(run["error"], "");
  EXPECT_EQ(run["num_warnings"], 1);
  EXPECT_EQ(run["warnings"][0], "FILE: 3 bytes too many");
  int with_status = 0;
  for (const auto& [status, count] : run["status"].items()) with_status += count.get<int>();
  EXPECT_EQ(with_status, 12);
  EXPECT_GE(run["p95_ms_per_frame"].get<double>(), 0.0);
  EXPECT_GE(run["mean_ms_per_frame"].get<double>(), 0.0);
  EXPECT_GT(run["peak_memory_mb"].get<double>(), 1.0);
  EXPECT_EQ(run["configuration"]["input"]["rate"], 0.0);
  EXPECT_THAT(run["notes"].dump(), HasSubstr("Doppler sign +1"));
}

// Eight scans of three returns: too few to register, and nothing else in the drive.
TEST(RunSequence, SaysWhyThereIsNoResult) {
  const ScratchFolder scratch;
  std::vector<RadarScan> scans = StaticScans(8, kForward, 1.0);
  for (RadarScan& scan : scans) {
    scan.returns.resize(3);
    scan.place = "drive/" + std::to_string(scan.stamp_ns) + ".pcd";
  }
  FakeScanSource source(scans);
  source.Warn("drive/0.pcd: 9 bytes too many");
  std::string error;
  ASSERT_EQ(RunSequence(RunConfig(), RequestFor(scratch.path()), &source, &error),
            RunStatus::kNoResult);
  EXPECT_THAT(error,
              ::testing::StartsWith("somewhere: none of 8 scans was registered or found standing; "
                                    "most often (8 scans): "));
  EXPECT_THAT(error, HasSubstr("first in drive/0.pcd"));
  EXPECT_THAT(error, HasSubstr("first warning: drive/0.pcd: 9 bytes too many"));
  EXPECT_EQ(RunJson(scratch.path())["error"], error);
  EXPECT_EQ(CountLines(scratch.path() / "trajectory_tum.txt"), 8);
}

TEST(RunSequence, ADriveOfOneScanIsAResultAndOneOfNoneIsNot) {
  const ScratchFolder scratch;
  std::string error;
  FakeScanSource one(StaticScans(1, kForward, 1.0));
  EXPECT_EQ(RunSequence(RunConfig(), RequestFor(scratch.path() / "one"), &one, &error),
            RunStatus::kDone)
      << error;
  FakeScanSource none({});
  EXPECT_EQ(RunSequence(RunConfig(), RequestFor(scratch.path() / "none"), &none, &error),
            RunStatus::kNoResult);
  EXPECT_EQ(error, "somewhere: there are no scans");
  // Nothing was asked for.
  FakeScanSource ignored(StaticScans(2, kForward, 1.0));
  RunRequest request = RequestFor(scratch.path() / "zero");
  request.num_frames = 0;
  EXPECT_EQ(RunSequence(RunConfig(), request, &ignored, &error), RunStatus::kDone);
}

TEST(RunSequence, TheWrittenConfigurationReadsBack) {
  const ScratchFolder scratch;
  RunConfig config;
  config.output.map_resolution = 0.75;
  FakeScanSource source(StaticScans(3, kForward, 1.0));
  std::string error;
  ASSERT_EQ(RunSequence(config, RequestFor(scratch.path()), &source, &error), RunStatus::kDone);
  const auto read = LoadRunConfig((scratch.path() / "config.yaml").string(), "", &error);
  ASSERT_TRUE(read) << error;
  EXPECT_EQ(EffectiveConfig(*read), EffectiveConfig(config));
}

TEST(RunSequence, SurfaceMapsNeedTheNeuralSubmap) {
  const ScratchFolder scratch;
  RunConfig config;
  config.output.map = OutputOptions::Map::kMesh;
  FakeScanSource refused({});
  std::string error;
  EXPECT_EQ(RunSequence(config, RequestFor(scratch.path() / "raw"), &refused, &error),
            RunStatus::kFailed);
  EXPECT_EQ(error,
            "output.map surface and mesh come from the neural submap: they need submap.type sdf");
  config.odometry.submap.type = SubmapOptions::Type::kSdf;
  for (const OutputOptions::Map map : {OutputOptions::Map::kMesh, OutputOptions::Map::kNone}) {
    config.output.map = map;
    FakeScanSource source(StaticScans(12, kForward, 1.0));
    ASSERT_EQ(RunSequence(config, RequestFor(scratch.path() / "sdf"), &source, &error),
              RunStatus::kDone)
        << error;
    for (const char* name : {"map.ply", "neural_points.ply", "mesh.ply", "sdf_slice.ply"}) {
      EXPECT_EQ(std::filesystem::exists(scratch.path() / "sdf" / name),
                map == OutputOptions::Map::kMesh)
          << name;
    }
  }
}

TEST(RunSequence, RepeatsToTheSameBytes) {
  const ScratchFolder scratch;
  std::string error;
  for (const char* folder : {"one", "two"}) {
    FakeScanSource source(StaticScans(15, kForward, -1.0));
    ASSERT_EQ(RunSequence(RunConfig(), RequestFor(scratch.path() / folder), &source, &error),
              RunStatus::kDone);
  }
  for (const char* file : {"trajectory_tum.txt", "trajectory_kitti.txt", "scans.csv", "map.ply"}) {
    EXPECT_EQ(ReadFile(scratch.path() / "one" / file), ReadFile(scratch.path() / "two" / file));
  }
}

TEST(RunSequence, StartAndFramesChooseAPart) {
  const ScratchFolder scratch;
  RunRequest request = RequestFor(scratch.path());
  request.start = 3;
  request.num_frames = 4;
  FakeScanSource source(StaticScans(12, kForward, 1.0));
  std::string error;
  ASSERT_EQ(RunSequence(RunConfig(), request, &source, &error), RunStatus::kDone) << error;
  EXPECT_EQ(CountLines(scratch.path() / "trajectory_tum.txt"), 4);
  EXPECT_EQ(ReadFile(scratch.path() / "trajectory_tum.txt").substr(0, 12), "0.300000000 ");
}

TEST(RunSequence, TheFirstPartOfADriveGivesTheSameLines) {
  const ScratchFolder scratch;
  std::string error;
  FakeScanSource whole(StaticScans(40, kForward, -1.0));
  ASSERT_EQ(RunSequence(RunConfig(), RequestFor(scratch.path() / "whole"), &whole, &error),
            RunStatus::kDone);
  RunRequest request = RequestFor(scratch.path() / "part");
  request.num_frames = 9;
  FakeScanSource part(StaticScans(40, kForward, -1.0));
  ASSERT_EQ(RunSequence(RunConfig(), request, &part, &error), RunStatus::kDone);
  const std::string lines = ReadFile(scratch.path() / "part" / "trajectory_tum.txt");
  EXPECT_EQ(ReadFile(scratch.path() / "whole" / "trajectory_tum.txt").rfind(lines, 0), 0u);
}

TEST(RunSequence, StartBehindTheEndIsAnError) {
  const ScratchFolder scratch;
  RunRequest request = RequestFor(scratch.path());
  request.start = 12;
  FakeScanSource source(StaticScans(12, kForward, 1.0));
  std::string error;
  EXPECT_EQ(RunSequence(RunConfig(), request, &source, &error), RunStatus::kFailed);
  EXPECT_EQ(error, "somewhere: no scan is left after leaving out the first 12 of 12");
}

TEST(RunSequence, AnInterruptedRunFinishesItsFiles) {
  const ScratchFolder scratch;
  RunConfig config;
  config.odometry.ego_velocity.enabled = false;  // so that no scan is held back
  std::atomic<bool> stop{false};
  RunRequest request = RequestFor(scratch.path());
  request.stop = &stop;
  FakeScanSource source(StaticScans(12, kForward, 1.0));
  source.before_next = [&stop](std::size_t num_read) { stop = num_read == 4; };
  std::string error;
  EXPECT_EQ(RunSequence(config, request, &source, &error), RunStatus::kInterrupted);
  EXPECT_EQ(CountLines(scratch.path() / "trajectory_tum.txt"), 5);  // the scan at hand included
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "map.ply"));
  EXPECT_EQ(RunJson(scratch.path())["interrupted"], true);
  EXPECT_EQ(RunJson(scratch.path())["frames"], 5);
}

// One pose gives no scores, which is no failure of a run that somebody stopped.
TEST(RunSequence, AnInterruptBeforeThereCanBeScoresIsNoFailure) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "truth.txt") << "0 0 0 0 0 0 0 1\n1 8 0 0 0 0 0 1\n";
  RunConfig config;
  config.input.doppler_sign = InputOptions::DopplerSign::kPlus;  // so that no scan is held back
  for (const std::size_t num_scans : {0, 1}) {
    std::atomic<bool> stop{num_scans == 0};
    RunRequest request = RequestFor(scratch.path() / "results");
    request.reference = (scratch.path() / "truth.txt").string();
    request.stop = &stop;
    FakeScanSource source(StaticScans(12, kForward, 1.0));
    source.before_next = [&stop](std::size_t) { stop = true; };
    std::string error;
    EXPECT_EQ(RunSequence(config, request, &source, &error), RunStatus::kInterrupted) << error;
    // Without any scan, earlier results are worth more.
    EXPECT_EQ(std::filesystem::exists(scratch.path() / "results" / "run.json"), num_scans == 1);
  }
  EXPECT_THAT(RunJson(scratch.path() / "results")["warnings"].dump(),
              ::testing::HasSubstr("truth.txt"));
}

TEST(RunSequence, ASourceThatBreaksLeavesWhatCameBefore) {
  const ScratchFolder scratch;
  FakeScanSource source(StaticScans(6, kForward, 1.0), "FILE.bin:6: expected whole records");
  std::string error;
  EXPECT_EQ(RunSequence(RunConfig(), RequestFor(scratch.path()), &source, &error),
            RunStatus::kFailed);
  EXPECT_EQ(error, "FILE.bin:6: expected whole records");
  EXPECT_EQ(CountLines(scratch.path() / "trajectory_tum.txt"), 6);
  EXPECT_EQ(RunJson(scratch.path())["error"], "FILE.bin:6: expected whole records");
}

TEST(RunSequence, OutputThatCannotBeWrittenIsAnErrorBeforeTheFirstScan) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "file") << "";
  FakeScanSource source(StaticScans(6, kForward, 1.0));
  std::string error;
  EXPECT_EQ(RunSequence(RunConfig(), RequestFor(scratch.path() / "file"), &source, &error),
            RunStatus::kFailed);
  EXPECT_THAT(error, HasSubstr("must be a folder, is a file"));
  EXPECT_EQ(source.num_read(), 0u);
}

TEST(RunSequence, WithoutMapAnEarlierMapGoes) {
  const ScratchFolder scratch;
  RunConfig config;
  std::string error;
  FakeScanSource first(StaticScans(6, kForward, 1.0));
  ASSERT_EQ(RunSequence(config, RequestFor(scratch.path()), &first, &error), RunStatus::kDone);
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "map.ply"));
  config.output.map = OutputOptions::Map::kNone;
  FakeScanSource second(StaticScans(6, kForward, 1.0));
  ASSERT_EQ(RunSequence(config, RequestFor(scratch.path()), &second, &error), RunStatus::kDone);
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / "map.ply"));
}

TEST(RunSequence, AWarningWhenTheDopplerSignStaysOpen) {
  const ScratchFolder scratch;
  FakeScanSource source(StaticScans(6, Eigen::Vector3d::Zero(), 1.0));
  std::string error;
  ASSERT_EQ(RunSequence(RunConfig(), RequestFor(scratch.path()), &source, &error),
            RunStatus::kDone);
  EXPECT_THAT(RunJson(scratch.path())["warnings"].dump(), HasSubstr("undecided, +1 assumed"));
}

}  // namespace
}  // namespace radive
