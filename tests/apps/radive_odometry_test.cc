// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Runs the program itself. RADIVE_ODOMETRY is its path, from CMake.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "radive/config/run_config.h"
#include "radive/util/exit_status.h"
#include "tests/apps/run_program.h"
#include "tests/scratch_folder.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::ReadFile;
using testing::ScratchFolder;
namespace fs = std::filesystem;

pid_t Start(const std::vector<std::string>& arguments, const fs::path& log) {
  return testing::StartProgram(RADIVE_ODOMETRY, arguments, log);
}

Outcome RunProgram(const std::vector<std::string>& arguments) {
  return testing::RunProgram(RADIVE_ODOMETRY, arguments);
}

// A drive of `count` scans with `num_returns` x y z doppler power records each; all are the same
// file, so that long drives cost no space. The radar moves forward with 5 m/s.
void MakeDrive(const fs::path& folder, int count, int num_returns) {
  fs::create_directories(folder);
  std::vector<float> records;
  for (int i = 0; i < num_returns; ++i) {
    const double azimuth = -1.0 + 2.0 * i / num_returns;
    const double range = 5.0 + i % 50;
    records.push_back(static_cast<float>(range * std::cos(azimuth)));
    records.push_back(static_cast<float>(range * std::sin(azimuth)));
    records.push_back(static_cast<float>(i % 7) * 0.2f);
    records.push_back(static_cast<float>(-5.0 * std::cos(azimuth)));
    records.push_back(20.0f);
  }
  char name[32];
  for (int i = 0; i < count; ++i) {
    std::snprintf(name, sizeof(name), "%06d.bin", i);
    if (i > 0) {
      fs::create_symlink("000000.bin", folder / name);
      continue;
    }
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(records.data()),
               static_cast<std::streamsize>(records.size() * sizeof(float)));
  }
}

int CountLines(const fs::path& path) {
  const std::string text = ReadFile(path);
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

class RadiveOdometry : public ::testing::Test {
 protected:
  std::vector<std::string> Arguments(const std::string& output,
                                     const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"--input",
                                          (scratch_.path() / "drive").string(),
                                          "--output",
                                          (scratch_.path() / output).string(),
                                          "--set",
                                          "input.layout=xyzdp5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  fs::path In(const std::string& name) const { return scratch_.path() / name; }

  ScratchFolder scratch_;
};

TEST_F(RadiveOdometry, WritesResultsAndRepeatsThem) {
  MakeDrive(In("drive"), 12, 60);
  const Outcome one = RunProgram(Arguments("one"));
  ASSERT_EQ(one.code, 0) << one.output;
  ASSERT_EQ(RunProgram(Arguments("two", {"--threads", "2", "--quiet"})).code, 0);
  EXPECT_EQ(CountLines(In("one") / "trajectory_tum.txt"), 12);
  for (const char* file : {"trajectory_tum.txt", "trajectory_kitti.txt", "scans.csv", "map.ply"}) {
    EXPECT_EQ(ReadFile(In("one") / file), ReadFile(In("two") / file)) << file;
  }
  const auto run = nlohmann::json::parse(ReadFile(In("one") / "run.json"));
  EXPECT_EQ(run["version"], RADIVE_VERSION);
  EXPECT_THAT(run["command_line"].get<std::string>(), HasSubstr("--set input.layout=xyzdp5"));
  // The effective configuration gives the same run again.
  const Outcome again = RunProgram({"--input",
                                    In("drive").string(),
                                    "--output",
                                    In("again").string(),
                                    "--config",
                                    (In("one") / "config.yaml").string()});
  ASSERT_EQ(again.code, 0) << again.output;
  EXPECT_EQ(ReadFile(In("one") / "scans.csv"), ReadFile(In("again") / "scans.csv"));
}

// README.md has the table of exit codes.
TEST_F(RadiveOdometry, ExitsWithTwoWithoutAResult) {
  MakeDrive(In("drive"), 5, 2);
  const Outcome outcome = RunProgram(Arguments("out", {"--quiet"}));
  EXPECT_EQ(outcome.code, Code(ExitStatus::kNoResult)) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("none of 5 scans was registered or found standing"));
  EXPECT_THAT(outcome.output, HasSubstr("drive/000000.bin"));
  EXPECT_EQ(RunProgram(Arguments("out", {"--frames=x"})).code, Code(ExitStatus::kFailure));
}

// gflags alone would keep the last --set, and the layout would be lost.
TEST_F(RadiveOdometry, TakesTheSettingsOfEachSet) {
  MakeDrive(In("drive"), 5, 60);
  const Outcome outcome = RunProgram(Arguments(
      "out", {"--set=input.rate=4,submap.num_keyframes=8", "-set", "submap.num_keyframes=9"}));
  ASSERT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_THAT(ReadFile(In("out") / "trajectory_tum.txt"), HasSubstr("\n1.000000000 "));
  EXPECT_THAT(ReadFile(In("out") / "config.yaml"), HasSubstr("num_keyframes: 9"));
}

TEST_F(RadiveOdometry, StartAndFramesChooseAPart) {
  MakeDrive(In("drive"), 12, 60);
  ASSERT_EQ(RunProgram(Arguments("out", {"--start=2", "--frames=5"})).code, 0);
  const std::string lines = ReadFile(In("out") / "trajectory_tum.txt");
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 5);
  EXPECT_EQ(lines.substr(0, 12), "0.200000000 ");
}

TEST_F(RadiveOdometry, AnInterruptFinishesTheFiles) {
  for (const int signal_number : {SIGINT, SIGTERM}) {
    const std::string name = std::to_string(signal_number);
    fs::remove_all(In("drive"));
    MakeDrive(In("drive"), 4000, 2000);
    const pid_t child =
        Start(Arguments(name, {"--set=input.layout=xyzdp5,ego_velocity.enabled=false"}),
              In("log" + name));
    const fs::path partial = In(name) / ".trajectory_tum.txt.partial";
    for (int i = 0; i < 2000 && CountLines(partial) < 5; ++i) usleep(5000);
    kill(child, signal_number);
    const Outcome outcome = testing::WaitForProgram(child, In("log" + name));
    EXPECT_EQ(outcome.code, 130) << outcome.output;
    const int frames = CountLines(In(name) / "trajectory_tum.txt");
    EXPECT_GE(frames, 5);
    EXPECT_LT(frames, 4000);
    const auto run = nlohmann::json::parse(ReadFile(In(name) / "run.json"));
    EXPECT_EQ(run["interrupted"], true);
    EXPECT_EQ(run["frames"], frames);
    EXPECT_EQ(CountLines(In(name) / "scans.csv"), frames + 1);
    EXPECT_TRUE(fs::exists(In(name) / "map.ply"));
  }
}

TEST_F(RadiveOdometry, SaysWhatIsWrong) {
  MakeDrive(In("drive"), 3, 60);
  EXPECT_THAT(RunProgram({}).output, HasSubstr("--input is missing"));
  const auto fails_with = [this](const std::vector<std::string>& more, const std::string& message) {
    const Outcome outcome = RunProgram(Arguments("out", more));
    EXPECT_EQ(outcome.code, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(message));
    EXPECT_FALSE(fs::exists(In("out") / "trajectory_tum.txt"));
  };
  fails_with({"--set=input.layuot=xyz3"}, "did you mean input.layout?");
  fails_with({"--config=" + In("none.yaml").string()}, "none.yaml: cannot read");
  fails_with({"--frames=-3"}, "--frames must be");
  fails_with({"--threads=0"}, "--threads must be");
  fails_with({"--start=3"}, "no scan is left");
  fails_with({"--input=" + In("nowhere").string()}, "nowhere");
  fs::create_directories(In("empty"));
  fails_with({"--input=" + In("empty").string()}, "empty");
  std::ofstream(In("file")) << "";
  fails_with({"--output=" + In("file").string()}, "must be a folder");
}

TEST_F(RadiveOdometry, NoticesAFullStandardOutput) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this machine";
  for (const char* flag : {"--help", "--help_config", "--version"}) {
    int status = 0;
    waitpid(Start({flag}, "/dev/full"), &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), Code(ExitStatus::kFailure)) << flag;
  }
}

TEST_F(RadiveOdometry, HelpIsShortAndHelpConfigIsComplete) {
  const Outcome help = RunProgram({"--help"});
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.output, HasSubstr("--help_config"));
  EXPECT_THAT(help.output, Not(HasSubstr("logtostderr")));
  EXPECT_EQ(RunProgram({"--version"}).output, "radive_odometry " RADIVE_VERSION "\n");

  const Outcome help_config = RunProgram({"--help_config"});
  EXPECT_EQ(help_config.code, 0);
  RunConfig defaults;
  for (const auto& [stage, fields] : defaults.Stages()) {
    EXPECT_THAT(help_config.output, HasSubstr("\n" + stage + ":\n"));
    for (const OptionField& field : fields) {
      EXPECT_THAT(help_config.output,
                  HasSubstr("\n  " + field.name + ": " + field.ToString() + "\n"));
    }
  }
}

}  // namespace
}  // namespace radive
