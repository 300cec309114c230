// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Runs the program, and the odometry after it, on made and on real data.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/apps/run_program.h"
#include "tests/io/scan_files.h"
#include "tests/shared_data.h"

namespace radive {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using testing::Floats;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunProgram;
using testing::SharedData;
using testing::TempFolder;

json Inspect(const std::string& path, const std::string& flags) {
  std::vector<std::string> arguments = {path, "--json"};
  if (!flags.empty()) arguments.push_back(flags);
  const Outcome run = RunProgram(RADIVE_INSPECT, arguments);
  EXPECT_EQ(run.code, 0) << run.output;
  return json::parse(run.output, nullptr, /*allow_exceptions=*/false);
}

// Three scans of a radar that drives ahead, no sign set: too few to decide.
TEST(RadiveInspect, PrintsOneBlock) {
  const TempFolder folder;
  const std::string record = Floats({20, 1, 0.5, -7, -10, 0.25, 0});
  for (const char* name : {"10.bin", "9.bin", "11.bin"})
    folder.Write(name, record + record + record);
  const Outcome run = RunProgram(RADIVE_INSPECT, {folder.string()});
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_THAT(run.output,
              AllOf(HasSubstr("input " + folder.string()),
                    HasSubstr("format:   raw (vod7); raw records, layout vod7: time is a scan"),
                    HasSubstr("v_r float32 -10 .. -10 -> doppler"),
                    HasSubstr("axes:     +x+y+z"),
                    HasSubstr("Doppler:  sign undecided"),
                    HasSubstr("scans:    3, 3 returns each (mean of the first 3), 3D"),
                    HasSubstr("times:    10 Hz, no gaps (over 3 stamps)")));
  const json report = Inspect(folder.string(), "--set=input.rate=5,input.doppler_sign=-1");
  EXPECT_EQ(report["rate"], 5.0);
  EXPECT_EQ(report["layout"], "vod7");
  EXPECT_EQ(report["num_scans"], 3);
  EXPECT_EQ(report["dimensions"], 3);
  EXPECT_EQ(report["fields"][4]["role"], "doppler");
  EXPECT_EQ(report["fields"][4]["min"], -10.0);
  EXPECT_EQ(report["why_no_drive"], "");
  EXPECT_THAT(report["doppler"].get<std::string>(), HasSubstr("sign -1 as set"));
}

TEST(RadiveInspect, TellsGapsAndStampsThatGoBack) {
  const TempFolder folder;
  for (int k = 0; k < 6; ++k) folder.Write(std::to_string(k) + ".bin", Floats({1, 2, 3}));
  folder.Write("times.txt", "0.0\n0.1\n0.2\n0.9\n0.8\n0.9\n");
  const json report = Inspect(folder.string(), "--set=input.layout=xyz3");
  EXPECT_NEAR(report["rate"].get<double>(), 10.0, 1e-9);
  EXPECT_EQ(report["num_gaps"], 1);
  EXPECT_NEAR(report["longest_interval"].get<double>(), 0.7, 1e-9);
  EXPECT_EQ(report["num_not_increasing"], 1);
  EXPECT_EQ(report["has_doppler"], false);
}

TEST(RadiveInspect, SaysWhatIsWrong) {
  const TempFolder folder;
  Outcome run = RunProgram(RADIVE_INSPECT, {folder.string()});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output, HasSubstr("no scans found; looked for bags"));
  run = RunProgram(RADIVE_INSPECT, {folder.string(), "--json"});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output, HasSubstr("\"error\""));
  run = RunProgram(RADIVE_INSPECT, {});
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.output, HasSubstr("the path of a dataset folder, bag or point file is missing"));
}

struct RealDrive {
  const char* path;
  const char* config;
  int num_scans;
};

constexpr RealDrive kDrives[] = {
    {"vod-radar-xyz/delft_04", "vod_xyz", 396},
    {"radarscenes/seq105", "radarscenes", 1606},
    {"mscrad4r-urban-c0", "mscrad4r", 310},
    {"mscrad4r-urban-c0/original-sample", "mscrad4r_original", 3},
    {"tj4dradset-sample", "tj4dradset", 41},
    {"raflow-inhouse", "raflow", 13},
    {"ti-iwr6843-rio-demo", "ti_iwr6843", 412},
};

// With nothing but the dataset's configuration, through both programs. Thirty scans are enough to
// see that it runs.
TEST(RealDrives, InspectAndRunWithTheirConfiguration) {
  for (const RealDrive& drive : kDrives) {
    RADIVE_SKIP_WITHOUT(drive.path);
    const std::string path = (SharedData() / drive.path).string();
    const std::string config =
        std::string("--config=") + RADIVE_CONFIGS + "/" + drive.config + ".yaml";
    const json report = Inspect(path, config);
    EXPECT_EQ(report["num_scans"], drive.num_scans) << drive.path;
    const TempFolder results;
    const Outcome run = RunProgram(RADIVE_ODOMETRY,
                                   {"--input=" + path,
                                    config,
                                    "--frames=30",
                                    "--output=" + (results.path() / "run").string()});
    EXPECT_EQ(run.code, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("input " + path)) << "the block comes first";
    EXPECT_TRUE(std::filesystem::exists(results.path() / "run" / "trajectory_tum.txt"));
  }
}

// Headers that promise what no memory holds, read by a process that has little.
TEST(RadiveInspect, HostileCountsCostNoMemory) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer reserves more address space than the limit";
#endif
  const TempFolder folder;
  const std::string pcd = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 4000000000\nHEIGHT 1\n";
  const std::string points = "POINTS 4000000000\n";
  folder.Write("a.pcd", pcd + points + "DATA ascii\n1 2 3\n");
  folder.Write("b.pcd", pcd + points + "DATA binary\n" + Floats({1, 2, 3}));
  folder.Write("c.pcd",
               pcd + "DATA binary_compressed\n" + std::string("\3\0\0\0\xF0\xFF\xFF\xFF", 8));
  folder.Write(
      "d.ply",
      "ply\nformat binary_little_endian 1.0\nelement vertex 18446744073709551615\nproperty "
      "float x\nproperty float y\nproperty list uint float w\nend_header\n" +
          Floats({1, 2}) + "\xFF\xFF\xFF\xFF");
  folder.Write("e.npy",
               std::string("\x93NUMPY\1\0\x46\0", 10) +
                   "{'descr': '<f8', 'fortran_order': True, 'shape': (99999999999999, 3)}\n");
  for (const char* name : {"a.pcd", "b.pcd", "c.pcd", "d.ply", "e.npy"}) {
    const std::string command = std::string("ulimit -v 400000; exec '") + RADIVE_INSPECT + "' '" +
                                (folder.path() / name).string() + "'";
    const Outcome run = RunProgram("/bin/sh", {"-c", command});
    // Of c and e nothing can be read.
    const bool has_points = name[0] != 'c' && name[0] != 'e';
    EXPECT_EQ(run.code, has_points ? 0 : 1) << name << run.output;
    EXPECT_THAT(run.output, HasSubstr(has_points ? "warning:" : name)) << name;
  }
}

// One decoded frame of an ARS548, as YAML.
TEST(RealDrives, AFrameInYaml) {
  RADIVE_SKIP_WITHOUT("ars548-nebula");
  const std::string name = "ars548-nebula/1708578204_202447652_detection.yaml";
  const json report = Inspect((SharedData() / name).string(), "");
  EXPECT_EQ(report["format"], "yaml");
  EXPECT_EQ(report["returns_per_scan"], 308.0);
  EXPECT_EQ(report["dimensions"], 3);
  EXPECT_EQ(report["has_doppler"], true);
  EXPECT_EQ(report["why_no_drive"], "there is only one scan");
}

// Bags without point clouds are refused by what they hold instead.
TEST(RealDrives, BagsWithoutPointCloudsSayWhatTheyHold) {
  RADIVE_SKIP_WITHOUT("trajectories/containers");
  RADIVE_SKIP_WITHOUT("ars548-nebula");
  for (const auto& [path, message] :
       {std::pair("trajectories/containers", "tf2_msgs/TFMessage"),
        std::pair("trajectories/containers/tf_example", "tf2_msgs/msg/TFMessage"),
        std::pair("ars548-nebula", "nebula_msgs/msg/NebulaPackets")}) {
    const Outcome run = RunProgram(RADIVE_INSPECT, {(SharedData() / path).string()});
    EXPECT_EQ(run.code, 1) << path;
    EXPECT_THAT(run.output, AllOf(HasSubstr("has no point clouds"), HasSubstr(message)));
  }
}

TEST(RealDrives, SingleFramesAreNoDrive) {
  RADIVE_SKIP_WITHOUT("vod-example-frames");
  const json report = Inspect((SharedData() / "vod-example-frames").string(), "");
  EXPECT_EQ(report["layout"], "vod7");
  EXPECT_THAT(report["why_no_drive"].get<std::string>(),
              HasSubstr("not consecutive (00549.bin, 01047.bin, 01201.bin)"));
}

}  // namespace
}  // namespace radive
