// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Runs the program itself on tiny simulated drives. RADIVE_BATCH is its path, from CMake.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "radive/util/random.h"
#include "tests/apps/run_program.h"
#include "tests/scratch_folder.h"
#include "tests/studies/study_file.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::ReadFile;
using testing::ScratchFolder;
using testing::WriteTextFile;
namespace fs = std::filesystem;

// Two short drives x two variants x two seeds: eight runs.
constexpr char kHead[] =
    "seeds: 0-1\n"
    "set: {input.format: raw, input.layout: xyzdp5, output.map: none}\n"
    "evaluate: {align: origin}\n"
    "sequences:\n"
    "  - {name: one, scenario: street_sparse, simulate: {frames: 16, rate: 5}}\n"
    "  - {name: two, scenario: street_sparse, simulate: {frames: 16, rate: 5, moving_cars: 0}}\n";
constexpr char kVariants[] =
    "variants:\n"
    "  - name: ours\n"
    "  - {name: plain, set: {ego_velocity.weights: false}}\n";

int CountLines(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

// The children of a process, for as long as they live.
std::vector<pid_t> ChildrenOf(pid_t parent) {
  std::vector<pid_t> children;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string stat = ReadFile(entry.path() / "stat");
    const std::size_t end = stat.rfind(')');
    if (end == std::string::npos) continue;
    std::istringstream fields(stat.substr(end + 1));
    std::string state;
    pid_t ppid = 0;
    fields >> state >> ppid;
    if (ppid == parent && state != "Z") children.push_back(std::stoi(name));
  }
  return children;
}

class RadiveBatch : public ::testing::Test {
 protected:
  fs::path In(const std::string& name) const { return scratch_.path() / name; }

  void WriteStudy(const std::string& text) { WriteTextFile(In("study.yaml"), text); }

  std::vector<std::string> Arguments(const std::string& output,
                                     const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {
        In("study.yaml").string(), "--output=" + In(output).string(), "--jobs=2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  Outcome Run(const std::string& output, const std::vector<std::string>& more = {}) const {
    return testing::RunProgram(RADIVE_BATCH, Arguments(output, more));
  }

  pid_t Start(const std::string& output, const std::vector<std::string>& more = {}) const {
    return testing::StartProgram(RADIVE_BATCH, Arguments(output, more), In("log_" + output));
  }

  std::string Results(const std::string& output) const {
    return ReadFile(In(output) / "results.csv");
  }

  // A program that does what `script` says, then runs radive_odometry. It notes each call.
  std::string Program(const std::string& script) const {
    const fs::path path =
        WriteTextFile(In("program.sh"),
                      "#!/bin/sh\necho \"$*\" >> '" + In("calls").string() + "'\n" + script +
                          "\nexec '" RADIVE_ODOMETRY "' \"$@\"\n");
    fs::permissions(path, fs::perms::owner_all);
    return "--program=" + path.string();
  }

  const ScratchFolder scratch_;
};

TEST_F(RadiveBatch, RunsEverythingOnce) {
  WriteStudy(std::string(kHead) + kVariants);
  const Outcome first = Run("out");
  ASSERT_EQ(first.code, 0) << first.output;
  EXPECT_THAT(first.output, HasSubstr("8/8 runs"));
  EXPECT_THAT(first.output, HasSubstr("runs: 8 ok; tables in"));
  const std::string results = Results("out");
  EXPECT_EQ(CountLines(results), 9);
  EXPECT_THAT(results, HasSubstr("\none,ours,0,ok,,"));
  EXPECT_EQ(CountLines(ReadFile(In("out") / "timings.csv")), 9);
  EXPECT_EQ(CountLines(ReadFile(In("out") / "summary.csv")), 1 + 2 * 3 * 4);
  EXPECT_THAT(ReadFile(In("out") / "summary.md"), HasSubstr("| plain |"));
  EXPECT_TRUE(fs::exists(In("out") / "results.sqlite"));

  // The scores are those of radive_evaluate, and run.json has the row.
  const fs::path run = In("out") / "runs/two/plain/1";
  const auto json = nlohmann::json::parse(ReadFile(run / "run.json"));
  EXPECT_EQ(json["batch"]["status"], "ok");
  EXPECT_EQ(json["batch"]["scans"], 16);
  EXPECT_EQ(json["frames"], 16);
  EXPECT_EQ(json["configuration"]["ego_velocity"]["weights"], false);
  EXPECT_THAT(json["command_line"].get<std::string>(), HasSubstr(run.string()));
  const Outcome evaluation =
      testing::RunProgram(RADIVE_EVALUATE,
                          {"--reference=" + (run / "reference.tum").string(),
                           "--estimate=" + (run / "trajectory_tum.txt").string(),
                           "--align=origin",
                           "--plane=xy",
                           "--json"});
  EXPECT_GT(json["batch"]["ate_t"].get<double>(), 1e-5);
  EXPECT_DOUBLE_EQ(nlohmann::json::parse(evaluation.output)["rmse"].get<double>(),
                   json["batch"]["ate_t"].get<double>());

  const auto before = fs::last_write_time(run / "run.json");
  const Outcome second = Run("out");
  EXPECT_EQ(second.code, 0) << second.output;
  EXPECT_THAT(second.output, HasSubstr("8 of 8 runs are complete and unchanged"));
  EXPECT_EQ(Results("out"), results);
  EXPECT_EQ(fs::last_write_time(run / "run.json"), before);
}

TEST_F(RadiveBatch, RunsAgainWhatHasChanged) {
  WriteStudy(std::string(kHead) + kVariants);
  ASSERT_EQ(Run("out").code, 0);
  const std::string results = Results("out");
  // Another setting of one variant.
  WriteStudy(std::string(kHead) +
             "variants:\n  - name: ours\n  - {name: plain, set: {submap.num_keyframes: 3}}\n");
  const Outcome changed = Run("out");
  EXPECT_EQ(changed.code, 0) << changed.output;
  EXPECT_THAT(changed.output, HasSubstr("4 of 8 runs are complete and unchanged"));
  EXPECT_EQ(CountLines(Results("out")), 9);
  // Another byte in one simulated scan: its four runs see another input. (The drive is put right
  // by removing it.)
  WriteStudy(std::string(kHead) + kVariants);
  ASSERT_EQ(Run("out").code, 0);
  EXPECT_EQ(Results("out"), results);
  fs::remove_all(In("out") / "data/one/1");
  const Outcome restored = Run("out");
  EXPECT_THAT(restored.output, HasSubstr("6 of 8 runs are complete and unchanged"));
  EXPECT_EQ(Results("out"), results);
}

TEST_F(RadiveBatch, RecordsCrashesFailuresAndTimeouts) {
  WriteStudy(std::string("timeout: 2\n") + kHead +
             "variants:\n  - name: ours\n  - name: crash\n  - name: fail\n  - name: slow\n");
  const std::string program = Program(
      "case \"$*\" in */one/crash/.1*) kill -SEGV $$;; */two/fail/*) echo 'radive_odometry: no, "
      "\"x\"'; "
      "exit 7;; */two/slow/.0*) sleep 60;; esac");
  const Outcome outcome = Run("out", {program});
  EXPECT_EQ(outcome.code, 2) << outcome.output;
  const std::string results = Results("out");
  EXPECT_EQ(CountLines(results), 17);
  EXPECT_THAT(results, HasSubstr("\none,crash,1,crashed,signal 11 (Segmentation fault),,"));
  EXPECT_THAT(results, HasSubstr("\ntwo,fail,0,failed,\"no, \"\"x\"\"\",,"));
  EXPECT_THAT(results, HasSubstr("\ntwo,slow,0,timeout,not done after 2 s,,"));
  EXPECT_THAT(results, HasSubstr("\ntwo,slow,1,ok,,"));
  EXPECT_THAT(outcome.output, HasSubstr("runs: 1 crashed, 2 failed, 12 ok, 1 timeout"));
  EXPECT_THAT(ReadFile(In("out") / "runs/two/fail/1/log.txt"), HasSubstr("no, \"x\""));

  // Left as they are on demand; otherwise tried again, and now they work.
  const Outcome left = Run("out", {program, "--retry=false"});
  EXPECT_EQ(left.code, 2);
  EXPECT_THAT(left.output, HasSubstr("16 of 16 runs"));
  EXPECT_EQ(Results("out"), results);
  fs::remove(In("calls"));
  const Outcome again = Run("out", {Program("")});
  EXPECT_EQ(again.code, 0) << again.output;
  EXPECT_THAT(Results("out"), Not(HasSubstr("crashed")));
}

TEST_F(RadiveBatch, ReportsWhatCannotBeReadAndFinishesTheRest) {
  fs::create_directories(In("broken"));
  WriteTextFile(In("no_truth/radar/000000.bin"), std::string(200, '\0'));
  const std::string more =
      "  - {name: broken, input: broken}\n"
      "  - {name: no_truth, input: no_truth, reference: nowhere.txt}\n"
      "  - {name: nowhere, input: nowhere}\n";
  WriteStudy(std::string("absent: mark\n") + kHead + more);
  const Outcome outcome = Run("out");
  EXPECT_EQ(outcome.code, 2) << outcome.output;
  EXPECT_THAT(
      Results("out"),
      HasSubstr("\nbroken,default,0,failed,\"" + In("broken").string() + ": no scans found"));
  EXPECT_THAT(Results("out"),
              HasSubstr("\nno_truth,default,0,failed," + In("nowhere.txt").string() +
                        ": cannot be read: No such file"));
  EXPECT_THAT(Results("out"),
              HasSubstr("\nnowhere,default,0,absent," + In("nowhere").string() + ": no such file"));
  EXPECT_THAT(Results("out"), HasSubstr("\ntwo,default,1,ok,,"));
  // Results outlive their input.
  fs::copy(In("out") / "data/one/0", In("nowhere"), fs::copy_options::recursive);
  Run("out");
  EXPECT_THAT(Results("out"), HasSubstr("\nnowhere,default,0,ok,"));
  fs::remove_all(In("nowhere"));
  Run("out");
  EXPECT_THAT(Results("out"), HasSubstr("\nnowhere,default,0,ok,"));
  fs::remove_all(In("out") / "runs/nowhere");
  // Without a mark, a sequence that is not there is a failure.
  WriteStudy(std::string(kHead) + "  - {name: nowhere, input: nowhere}\n");
  EXPECT_EQ(Run("out").code, 2);
  EXPECT_THAT(Results("out"), HasSubstr("\nnowhere,default,0,failed,"));
}

// A drive that is away, or becomes another one, while a run reads it: that run does not count, and
// is done again.
TEST_F(RadiveBatch, RunsOverInputThatChangesFail) {
  WriteStudy(kHead);
  ASSERT_EQ(Run("simulated").code, 0);
  for (const char* name : {"away", "changed"}) {
    fs::copy(In("simulated") / "data/one/0", In(name), fs::copy_options::recursive);
  }
  WriteStudy(
      "set: {input.format: raw, input.layout: xyzdp5, output.map: none}\n"
      "sequences:\n"
      "  - {name: away, input: away}\n"
      "  - {name: changed, input: changed}\n");
  const std::string changed = In("changed").string();
  const Outcome outcome =
      Run("out",
          {Program("case \"$*\" in */away/*) mv '" + In("away").string() + "' '" +
                   In("elsewhere").string() +
                   "';; */changed/*) '" RADIVE_ODOMETRY "' \"$@\" && echo '# more' >> '" + changed +
                   "/times.txt'; exit 0;; esac")});
  EXPECT_EQ(outcome.code, 2) << outcome.output;
  EXPECT_THAT(Results("out"), HasSubstr("\naway,default,0,failed," + In("away").string()));
  EXPECT_THAT(Results("out"),
              HasSubstr("\nchanged,default,0,failed," + changed + ": changed while it was read"));
  fs::rename(In("elsewhere"), In("away"));
  const Outcome again = Run("out", {Program("")});
  EXPECT_EQ(again.code, 0) << again.output;
  EXPECT_THAT(Results("out"), Not(HasSubstr("failed")));
}

// Files may not grow beyond 40 KiB: to the runs of the long drive that is what a full disk is.
TEST_F(RadiveBatch, ReportsAFullDiskAndFinishesTheRest) {
  WriteStudy(std::string(kHead) +
             "  - {name: long, scenario: street_sparse, simulate: {frames: 100, rate: 5}}\n");
  const auto shell = [this](const std::string& limit) {
    std::string command = limit + "exec " + RADIVE_BATCH;
    for (const std::string& argument : Arguments("out")) command += " '" + argument + "'";
    return testing::RunProgram("/bin/sh", {"-c", command});
  };
  const Outcome outcome = shell("trap '' XFSZ; ulimit -f 80; ");
  EXPECT_EQ(outcome.code, 2) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("long/default/0: failed: "));
  EXPECT_THAT(outcome.output, HasSubstr("cannot be written: File too large"));
  EXPECT_THAT(outcome.output, HasSubstr("2 failed, 4 ok"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("0.partial")));
  EXPECT_THAT(Results("out"), HasSubstr("\nlong,default,1,failed,"));
  EXPECT_EQ(shell("").code, 0);
  EXPECT_THAT(Results("out"), HasSubstr("\nlong,default,1,ok,,"));
}

TEST_F(RadiveBatch, ShardsGiveTheSameTables) {
  WriteStudy(std::string(kHead) + kVariants);
  ASSERT_EQ(Run("whole").code, 0);
  const Outcome one = Run("parts", {"--shard=0/2"});
  EXPECT_EQ(one.code, 0) << one.output;
  EXPECT_THAT(one.output, HasSubstr("4/4 runs"));
  const Outcome missing = Run("parts", {"--collect"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.output, HasSubstr("4 of 8 runs"));
  EXPECT_EQ(Run("parts", {"--shard=1/2"}).code, 0);
  EXPECT_EQ(Run("parts", {"--collect"}).code, 0);
  EXPECT_EQ(Results("parts"), Results("whole"));
}

TEST_F(RadiveBatch, TwoProcessesShareTheWork) {
  WriteStudy(std::string(kHead) + kVariants);
  ASSERT_EQ(Run("alone").code, 0);
  // The programs differ in their bytes, and so in the last column of the table.
  const auto without_program = [](std::string text) {
    std::string out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      out += line.substr(0, line.rfind(',')) + "\n";
    }
    return out;
  };
  const std::string program = Program("");
  const pid_t one = Start("both", {program});
  const pid_t two = testing::StartProgram(RADIVE_BATCH, Arguments("both", {program}), In("log2"));
  EXPECT_EQ(testing::WaitForProgram(one, In("log_both")).code, 0);
  EXPECT_EQ(testing::WaitForProgram(two, In("log2")).code, 0);
  EXPECT_EQ(without_program(Results("both")), without_program(Results("alone")));
  EXPECT_EQ(CountLines(ReadFile(In("calls"))), 8);  // no run twice
}

// What the one that dies has claimed is free again, and the other does it.
TEST_F(RadiveBatch, OneOfTwoProcessesMayDie) {
  WriteStudy(std::string(kHead) + kVariants);
  ASSERT_EQ(Run("alone").code, 0);
  const pid_t one = Start("both");
  const pid_t two = testing::StartProgram(RADIVE_BATCH, Arguments("both"), In("log2"));
  usleep(100000);
  kill(one, SIGKILL);
  testing::WaitForProgram(one, In("log_both"));
  const Outcome outcome = testing::WaitForProgram(two, In("log2"));
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  EXPECT_EQ(Results("both"), Results("alone"));
}

TEST_F(RadiveBatch, AnInterruptLeavesAStudyToGoOnWith) {
  WriteStudy(std::string(kHead) + kVariants);
  const std::string program = Program("case \"$*\" in */two/*) sleep 60 & wait;; esac");
  const pid_t batch = Start("out", {program});
  for (int i = 0; i < 2000 && CountLines(ReadFile(In("calls"))) < 6; ++i) usleep(5000);
  const std::vector<pid_t> children = ChildrenOf(batch);
  EXPECT_EQ(children.size(), 2u);
  kill(batch, SIGINT);
  const Outcome outcome = testing::WaitForProgram(batch, In("log_out"));
  EXPECT_EQ(outcome.code, 130) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("the same command goes on from here"));
  for (const pid_t child : children) EXPECT_NE(kill(child, 0), 0);
  EXPECT_EQ(CountLines(Results("out")), 5);
  fs::remove(In("calls"));
  EXPECT_EQ(Run("out", {Program("")}).code, 0);
  EXPECT_EQ(CountLines(Results("out")), 9);
}

// kill -9 at random moments, of the program and of its children: what was complete stays, what was
// not is run again, and the table is the same in the end.
TEST_F(RadiveBatch, SurvivesKills) {
  WriteStudy(std::string(kHead) + kVariants);
  ASSERT_EQ(Run("alone").code, 0);
  const std::string expected = Results("alone");
  Random random(5);
  int num_kills = 0;
  for (int round = 0; round < 4; ++round) {
    const std::string output = "killed_" + std::to_string(round);
    for (int i = 0; i < 5; ++i) {
      const pid_t batch = Start(output);
      usleep(static_cast<useconds_t>(random.Uniform(1e3, 120e3)));
      const std::vector<pid_t> children = ChildrenOf(batch);
      if (random.Uniform() < 0.4 && !children.empty()) {
        num_kills += kill(children[random.Index(children.size())], SIGKILL) == 0 ? 1 : 0;
        usleep(static_cast<useconds_t>(random.Uniform(1e3, 30e3)));
      }
      num_kills += kill(batch, SIGKILL) == 0 ? 1 : 0;
      testing::WaitForProgram(batch, In("log_" + output));
    }
    const Outcome outcome = Run(output);
    EXPECT_EQ(outcome.code, 0) << outcome.output;
    EXPECT_EQ(Results(output), expected);
  }
  EXPECT_GE(num_kills, 20);
}

TEST_F(RadiveBatch, KeepsWhatIsAskedFor) {
  WriteStudy(std::string(kHead) + "variants:\n  - {name: ours, set: {output.map: points}}\n");
  const auto has = [this](const std::string& output, const std::string& file) {
    return fs::exists(In(output) / "runs/one/ours/0" / file);
  };
  ASSERT_EQ(Run("all").code, 0);
  EXPECT_TRUE(has("all", "map.ply") && has("all", "scans.csv") && has("all", "reference.tum"));
  ASSERT_EQ(Run("trajectories", {"--keep=trajectories"}).code, 0);
  EXPECT_FALSE(has("trajectories", "map.ply") || has("trajectories", "scans.csv"));
  EXPECT_TRUE(has("trajectories", "trajectory_tum.txt") && has("trajectories", "reference.tum"));
  ASSERT_EQ(Run("scores", {"--keep=scores"}).code, 0);
  EXPECT_FALSE(has("scores", "trajectory_tum.txt") || has("scores", "reference.tum"));
  EXPECT_TRUE(has("scores", "run.json") && has("scores", "log.txt"));
  EXPECT_EQ(Results("scores"), Results("all"));
}

TEST_F(RadiveBatch, SaysWhatIsWrong) {
  WriteStudy(std::string(kHead) + kVariants);
  const auto fails_with = [this](const std::vector<std::string>& more, const std::string& message) {
    const Outcome outcome = Run("out", more);
    EXPECT_EQ(outcome.code, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(message));
  };
  EXPECT_THAT(testing::RunProgram(RADIVE_BATCH, {}).output, HasSubstr("study file is missing"));
  fails_with({"--shard=2/2"}, "--shard must be i/n with 0 <= i < n, is 2/2");
  fails_with({"--shard=x"}, "--shard must be");
  fails_with({"--jobs=-1"}, "--jobs must be >= 0");
  fails_with({"--keep=some"}, "--keep must be one of all | trajectories | scores");
  fails_with({"--program=/nowhere/radive"}, "/nowhere/radive: no such program");
  fails_with({"--output=/proc/nowhere"}, "the output folder cannot be made");
  WriteStudy("sequences: 1\n");
  fails_with({}, "study.yaml:1: sequences must be a list");
}

}  // namespace
}  // namespace radive
