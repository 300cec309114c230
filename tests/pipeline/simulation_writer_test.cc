// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/simulation_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "radive/io/bytes/byte_order.h"
#include "radive/simulation/radar_simulator.h"
#include "radive/simulation/scenarios.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

std::string Bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<float> Floats(const std::string& bytes) {
  std::vector<float> values;
  for (std::size_t i = 0; i + sizeof(float) <= bytes.size(); i += sizeof(float)) {
    values.push_back(NumberAt<float>(bytes.data() + i));
  }
  return values;
}

class SimulationWriterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("radive_simulation_") + info->name());
    fs::remove_all(folder_);
    options_ = ScenarioOptions("street_sparse").value();
    options_.rate = 2.0;
    options_.frames = 12;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_;
  SimulationOptions options_;
  std::string error_;
};

TEST_F(SimulationWriterTest, FilesHoldWhatTheSimulatorSays) {
  int last_done = 0;
  const auto progress = [&](int done, int all) {
    EXPECT_EQ(done, ++last_done);
    EXPECT_EQ(all, 12);
  };
  ASSERT_TRUE(WriteSimulation("street_sparse", options_, "raw", folder_, progress, &error_))
      << error_;
  EXPECT_EQ(last_done, 12);

  std::istringstream times(Bytes(folder_ / "times.txt"));
  std::istringstream poses(Bytes(folder_ / "gt_tum.txt"));
  RadarSimulator simulator(options_);
  RadarScan scan;
  GroundTruth truth;
  Rigid3 T_first_world;
  for (int k = 0; simulator.Next(&scan, &truth); ++k) {
    if (k == 0) T_first_world = truth.T_world_radar.Inverse();
    char name[16];
    std::snprintf(name, sizeof(name), "%06d.bin", k);
    const std::vector<float> values = Floats(Bytes(folder_ / "radar" / name));
    const std::string labels = Bytes(folder_ / "labels" / name);
    ASSERT_EQ(values.size(), 5 * scan.returns.size());
    ASSERT_EQ(labels.size(), scan.returns.size());
    for (std::size_t i = 0; i < scan.returns.size(); ++i) {
      EXPECT_EQ(values[5 * i], static_cast<float>(scan.returns[i].position.x()));
      EXPECT_EQ(values[5 * i + 1], static_cast<float>(scan.returns[i].position.y()));
      EXPECT_EQ(values[5 * i + 2], static_cast<float>(scan.returns[i].position.z()));
      EXPECT_EQ(values[5 * i + 3], static_cast<float>(scan.returns[i].doppler));
      EXPECT_EQ(values[5 * i + 4], static_cast<float>(scan.returns[i].power));
      EXPECT_EQ(static_cast<std::uint8_t>(labels[i]), static_cast<std::uint8_t>(truth.labels[i]));
    }
    std::int64_t stamp = -1;
    ASSERT_TRUE(times >> stamp);
    EXPECT_EQ(stamp, scan.stamp_ns);
    double seconds, x, y, z, qx, qy, qz, qw;
    ASSERT_TRUE(poses >> seconds >> x >> y >> z >> qx >> qy >> qz >> qw);
    EXPECT_NEAR(seconds, static_cast<double>(scan.stamp_ns) * 1e-9, 1e-9);
    const Rigid3 expected = T_first_world * truth.T_world_radar;
    EXPECT_LT((Eigen::Vector3d(x, y, z) - expected.translation).norm(), 2e-9);
    EXPECT_LT(
        RotationVector(expected.rotation.conjugate() * Eigen::Quaterniond(qw, qx, qy, qz)).norm(),
        1e-8);
  }
  std::string rest;
  EXPECT_FALSE(times >> rest);
  EXPECT_FALSE(poses >> rest);
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
  }
}

// One metre is 00 00 80 3f in little-endian float32; the first pose is the identity.
TEST_F(SimulationWriterTest, FirstPoseIsTheIdentity) {
  ASSERT_TRUE(WriteSimulation("street_sparse", options_, "raw", folder_, {}, &error_)) << error_;
  const std::string poses = Bytes(folder_ / "gt_tum.txt");
  EXPECT_EQ(poses.substr(0, poses.find('\n')),
            "0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 "
            "1.000000000");
  const std::string json = Bytes(folder_ / "scenario.json");
  EXPECT_NE(json.find("\"sensor\": \"ars548\""), std::string::npos) << json;
  EXPECT_NE(json.find("\"num_scans\": 12,"), std::string::npos) << json;
  EXPECT_NE(json.find("\"layout\": \"xyzdp5\""), std::string::npos) << json;
}

TEST_F(SimulationWriterTest, SameBytesTwice) {
  const fs::path again = folder_.string() + "_again";
  fs::remove_all(again);
  ASSERT_TRUE(WriteSimulation("street_sparse", options_, "raw", folder_, {}, &error_)) << error_;
  ASSERT_TRUE(WriteSimulation("street_sparse", options_, "raw", again, {}, &error_)) << error_;
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    if (!entry.is_regular_file()) continue;
    ++files;
    EXPECT_EQ(Bytes(entry.path()), Bytes(again / fs::relative(entry.path(), folder_)))
        << entry.path();
  }
  EXPECT_EQ(files, 2 * 12 + 3);
  fs::remove_all(again);
}

TEST_F(SimulationWriterTest, RefusesAFolderThatHoldsSomething) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "notes.txt") << "mine";
  EXPECT_FALSE(WriteSimulation("street_sparse", options_, "raw", folder_, {}, &error_));
  EXPECT_EQ(error_,
            folder_.string() + ": the output folder must be new or empty; it holds notes.txt");
  EXPECT_FALSE(fs::exists(folder_ / "radar"));
}

TEST_F(SimulationWriterTest, NamesTheFolderThatCannotBeMade) {
  std::ofstream(folder_) << "a file";
  const fs::path below = folder_ / "below";
  EXPECT_FALSE(WriteSimulation("street_sparse", options_, "raw", below, {}, &error_));
  EXPECT_EQ(error_.rfind(below.string(), 0), 0u) << error_;
}

}  // namespace
}  // namespace radive
