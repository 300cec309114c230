// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gflags/gflags.h>
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <string>

#include "apps/app_main.h"
#include "radive/config/load_config.h"
#include "radive/pipeline/simulation_writer.h"
#include "radive/simulation/scenarios.h"

DEFINE_string(scenario,
              "street_dense",
              "PLACE_SENSOR with the places street, avenue, campus, car_park, tunnel, stop_and_go, "
              "handcart, outages and the sensors dense, sparse, planar, aeva.");
DEFINE_int32(seed, 1, "Seed of the world, the traffic, the drive and all noise.");
DEFINE_int32(frames, 0, "Number of scans; 0: two minutes.");
DEFINE_string(set,
              "",
              "Settings that win over the scenario's: simulation.field=value, separated by commas "
              "outside brackets; scenario.json of any result lists the fields.");
DEFINE_string(format,
              "raw",
              "Form of the scans: raw (float32 x y z doppler power) | pcd_ascii | pcd_binary | "
              "pcd_compressed | ply_ascii | ply_binary | ply_big_endian | csv | npy | hercules | "
              "aeva | snail | vod | tj4d | coloradar | rosbag1 | rosbag1_bz2 | rosbag1_lz4 | "
              "rosbag1_unindexed | rosbag2 | "
              "rosbag2_zstd | mcap | mcap_lz4 | mcap_zstd | mcap_unindexed.");
DEFINE_string(output, "", "Folder for the scans and their truth; new or empty. Required.");

namespace {

int Fail(const std::string& message) {
  std::fprintf(stderr, "radive_simulate: %s\n", message.c_str());
  return radive::Code(radive::ExitStatus::kFailure);
}

}  // namespace

int main(int argc, char** argv) {
  radive::InitApp(&argc,
                  &argv,
                  "Simulates a radar on a drive, with exact poses and labels.\n"
                  "  radive_simulate --scenario=street_dense --seed=1 --output=FOLDER\n\n"
                  "Writes radar/NNNNNN.bin (or the files of --format), times.txt, gt_tum.txt,\n"
                  "labels/NNNNNN.bin and scenario.json.");
  if (FLAGS_output.empty()) return Fail("--output is required: the folder for the scans");
  std::optional<radive::SimulationOptions> options = radive::ScenarioOptions(FLAGS_scenario);
  if (!options) {
    std::string names;
    for (const std::string& name : radive::ScenarioNames()) names += " " + name;
    return Fail("--scenario must be one of" + names + ", is " + FLAGS_scenario);
  }
  options->seed = FLAGS_seed;
  if (FLAGS_frames != 0) options->frames = FLAGS_frames;
  std::string error;
  if (!radive::ApplySettings(FLAGS_set, {{"simulation", options->Fields()}}, &error)) {
    return Fail(error);
  }

  const bool on_terminal = isatty(STDERR_FILENO) != 0;
  const auto progress = [on_terminal](int done, int all) {
    if (!on_terminal || (done % 10 != 0 && done != all)) return;
    std::fprintf(stderr, "\r%d / %d scans%s", done, all, done == all ? "\n" : "");
  };
  if (!radive::WriteSimulation(
          FLAGS_scenario, *options, FLAGS_format, FLAGS_output, progress, &error)) {
    return Fail(error);
  }
  std::printf("%d scans in %s\n", options->frames, FLAGS_output.c_str());
  return radive::EndApp(radive::ExitStatus::kSuccess);
}
