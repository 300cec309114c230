// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <atomic>
#include <clocale>
#include <filesystem>
#include <locale>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

#include "radive/config/load_config.h"
#include "radive/io/open/open_scan_source.h"
#include "radive/pipeline/run_sequence.h"
#include "radive/pipeline/simulation_writer.h"
#include "radive/simulation/scenarios.h"
#include "tests/foreign_locales.h"
#include "tests/scratch_folder.h"

// A program that uses the library may have set a locale with a decimal comma and a separator of
// thousands (Qt, GTK and ROS nodes do), or set one while the library works.

namespace radive {
namespace {

namespace fs = std::filesystem;
using testing::ForeignLocales;
using testing::ReadFile;
using testing::ScratchFolder;

using Files = std::map<std::string, std::string>;

// Without what is measured.
std::string Lasting(const std::string& json) {
  std::istringstream lines(json);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    const bool is_measured = line.find("_ms_per_frame") != line.npos ||
                             line.find("_seconds") != line.npos ||
                             line.find("_memory_mb") != line.npos;
    if (!is_measured) text += line + "\n";
  }
  return text;
}

void AddFiles(const fs::path& folder, const std::string& prefix, Files* files) {
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = prefix + entry.path().lexically_relative(folder).string();
    if (!entry.is_regular_file() || entry.path().filename() == "timing.csv") continue;
    const std::string bytes = ReadFile(entry.path());
    (*files)[name] = entry.path().filename() == "run.json" ? Lasting(bytes) : bytes;
  }
}

// Everything that a short drive leaves, by the names of the files.
Files WriteEverything() {
  Files files;
  for (const std::string format : {"csv", "pcd_ascii", "ply_ascii", "npy", "rosbag2", "snail"}) {
    const ScratchFolder scratch;
    std::string error, scores;
    SimulationOptions simulation = ScenarioOptions("street_sparse").value();
    simulation.frames = 12;
    simulation.rate = 4.0;
    const fs::path drive = scratch.path() / "drive", results = scratch.path() / "results";
    EXPECT_TRUE(WriteSimulation("street_sparse", simulation, format, drive, nullptr, &error))
        << error;
    const auto config = ParseRunConfig(
        "sensor:\n  sigma_range: 0.2\n  mounts: [1.5, 2.25]\n"
        "submap:\n  keyframe_distance: 1.5\n"
        "sensor_of_nothing:\n",
        "my.yaml",
        "",
        &error);
    EXPECT_FALSE(config);
    files[format + ": message"] = error;
    const auto settings = ParseRunConfig(
        "sensor:\n  sigma_range: 0.2\n", "my.yaml", "registration.planar=true", &error);
    if (!settings) return {{"error", error}};
    const auto source = OpenScanSource(drive, settings->input, &error);
    if (source == nullptr) return {{"error", error}};
    RunRequest request;
    request.input = "drive";
    request.output = results.string();
    request.reference = (drive / "gt_tum.txt").string();
    request.quiet = true;
    EXPECT_EQ(RunSequence(*settings, request, source.get(), &error, &scores), RunStatus::kDone)
        << error;
    AddFiles(drive, format + "/drive/", &files);
    AddFiles(results, format + "/results/", &files);
    for (auto& [name, bytes] : files) {
      for (std::size_t at; (at = bytes.find(scratch.path().string())) != bytes.npos;) {
        bytes.replace(at, scratch.path().string().size(), "SCRATCH");
      }
    }
    const std::string timing = ReadFile(results / "timing.csv");
    files[format + ": commas in timing.csv"] =
        std::to_string(std::count(timing.begin(), timing.end(), ','));
    files[format + ": scores"] = scores.substr(scores.find('\n'));
  }
  return files;
}

void ExpectSame(const Files& actual, const Files& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (const auto& [name, bytes] : expected) {
    ASSERT_EQ(actual.count(name), 1U) << name;
    EXPECT_EQ(actual.at(name) == bytes, true) << name << ": " << actual.at(name).substr(0, 300);
  }
}

TEST(Locale, FilesAreTheSameInEveryLocaleOfTheProgram) {
  const ForeignLocales locales;
  if (!locales.are_there()) GTEST_SKIP() << "no package `locales`";
  const Files expected = WriteEverything();
  ASSERT_GT(expected.size(), 100U);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
    ASSERT_NE(std::setlocale(LC_ALL, name), nullptr);
    ExpectSame(WriteEverything(), expected);
    std::locale::global(std::locale(name));  // of iostreams too
    ExpectSame(WriteEverything(), expected);
    std::locale::global(std::locale::classic());
  }
}

TEST(Locale, FilesAreTheSameWhileAnotherThreadChangesTheLocale) {
  const ForeignLocales locales;
  if (!locales.are_there()) GTEST_SKIP() << "no package `locales`";
  const Files expected = WriteEverything();
  std::atomic<bool> stop{false};
  std::thread changer([&stop] {
    const char* const names[] = {"de_DE.UTF-8", "C", "fr_FR.UTF-8"};
    for (int i = 0; !stop; ++i) {
      std::setlocale(LC_ALL, names[i % 3]);
      std::this_thread::yield();
    }
  });
  const Files actual = WriteEverything();
  stop = true;
  changer.join();
  ExpectSame(actual, expected);
}

}  // namespace
}  // namespace radive
