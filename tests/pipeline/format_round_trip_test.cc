// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// One simulated drive, written in every form: the same scans and the same trajectory.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "radive/io/open/open_scan_source.h"
#include "radive/io/open/open_scan_writer.h"
#include "radive/odometry/odometry.h"
#include "radive/pipeline/simulation_writer.h"
#include "radive/simulation/scenarios.h"
#include "tests/io/scan_files.h"

namespace radive {
namespace {

class FormatRoundTrip : public ::testing::TestWithParam<std::string> {
 protected:
  // The drive in that form, read without being told the form (but for the columns of raw files).
  static std::vector<RadarScan> Simulate(const std::string& format) {
    const testing::TempFolder folder;
    SimulationOptions options = ScenarioOptions("street_sparse").value();
    options.rate = 10.0;
    options.frames = 50;
    std::string error;
    EXPECT_TRUE(
        WriteSimulation("street_sparse", options, format, folder.path() / "drive", {}, &error))
        << error;
    InputOptions input;
    if (format == "raw") input.layout = "xyzdp5";
    const auto source = OpenScanSource((folder.path() / "drive").string(), input, &error);
    if (source == nullptr) {
      ADD_FAILURE() << error;
      return {};
    }
    return testing::ReadAll(source.get());
  }

  static std::vector<Rigid3> Trajectory(const std::vector<RadarScan>& scans) {
    Odometry odometry{OdometryOptions()};
    std::vector<Rigid3> poses;
    for (const RadarScan& scan : scans) poses.push_back(odometry.AddScan(scan).T_world_radar);
    return poses;
  }
};

TEST_P(FormatRoundTrip, GivesTheSameScansAndTheSameTrajectory) {
  static const std::vector<RadarScan>* const expected = new std::vector<RadarScan>(Simulate("raw"));
  const std::vector<RadarScan> scans = Simulate(GetParam());
  ASSERT_EQ(expected->size(), 50u);
  ASSERT_EQ(scans.size(), expected->size());
  for (std::size_t k = 0; k < scans.size(); ++k) {
    EXPECT_EQ(scans[k].stamp_ns, static_cast<std::int64_t>(k) * 100000000);
    ASSERT_EQ(scans[k].returns.size(), (*expected)[k].returns.size());
    ASSERT_GT(scans[k].returns.size(), 20u);
    for (std::size_t i = 0; i < scans[k].returns.size(); ++i) {
      EXPECT_EQ(scans[k].returns[i].position, (*expected)[k].returns[i].position);
      EXPECT_EQ(scans[k].returns[i].doppler, (*expected)[k].returns[i].doppler);
    }
  }
  const std::vector<Rigid3> poses = Trajectory(scans);
  const std::vector<Rigid3> expected_poses = Trajectory(*expected);
  EXPECT_GT(poses.back().translation.norm(), 5.0) << "the vehicle moves";
  for (std::size_t k = 0; k < poses.size(); ++k) {
    EXPECT_EQ(poses[k].translation, expected_poses[k].translation);
    EXPECT_EQ(poses[k].rotation.coeffs(), expected_poses[k].rotation.coeffs());
  }
}

INSTANTIATE_TEST_SUITE_P(Formats,
                         FormatRoundTrip,
                         ::testing::ValuesIn(ScanWriterNames()),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace radive
