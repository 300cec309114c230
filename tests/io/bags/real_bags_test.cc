// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Bags that others wrote.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "radive/io/open/open_scan_source.h"
#include "tests/io/bags/bag_files.h"
#include "tests/io/scan_files.h"
#include "tests/shared_data.h"

namespace radive {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::SharedData;

std::string ErrorOf(const std::string& place, InputOptions::Format format) {
  InputOptions options;
  options.format = format;
  std::string error;
  EXPECT_EQ(OpenScanSource((SharedData() / place).string(), options, &error), nullptr);
  return error;
}

TEST(RealBags, TiDemoHasItsScansAndTheStampsOfItsTriggers) {
  RADIVE_SKIP_WITHOUT("ti-iwr6843-rio-demo");
  const std::string path =
      (SharedData() / "ti-iwr6843-rio-demo" / "ti_mmwave_rospkg_demo.bag").string();
  InputOptions options;
  options.format = InputOptions::Format::kRosbag1;
  std::string error;
  const auto source = OpenScanSource(path, options, &error);
  ASSERT_NE(source, nullptr) << error;
  EXPECT_EQ(source->NumScans(), 412);
  const std::vector<RadarScan> scans = testing::ReadAll(source.get());
  ASSERT_EQ(scans.size(), 412u);
  EXPECT_THAT(source->TakeWarnings(),
              ElementsAre(HasSubstr(
                  "the stamps of the triggers /sensor_platform/radar_right/trigger are taken")));
  // Of the two triggers before the first scan the later one, which is as long before it (27 ms, by
  // the times of recording) as all others before theirs.
  EXPECT_NEAR(1e-9 * static_cast<double>(scans[0].stamp_ns), 1631895354.018503, 1e-5);
  std::size_t num_returns = 0;
  std::size_t least = 1000;
  std::size_t most = 0;
  for (const RadarScan& scan : scans) {
    num_returns += scan.returns.size();
    least = std::min(least, scan.returns.size());
    most = std::max(most, scan.returns.size());
    for (const RadarReturn& point : scan.returns) EXPECT_GT(point.position.x(), 0.0);
  }
  // As the description of the data says: 19 to 87 points, 43 on average.
  EXPECT_EQ(least, 19u);
  EXPECT_EQ(most, 87u);
  EXPECT_NEAR(static_cast<double>(num_returns) / 412.0, 43.0, 0.5);
  // The trigger runs at 10.24 Hz, and evenly.
  for (std::size_t k = 1; k < scans.size(); ++k) {
    EXPECT_NEAR(static_cast<double>(scans[k].stamp_ns - scans[k - 1].stamp_ns), 97.68e6, 0.1e6);
  }
  const double seconds = 1e-9 * static_cast<double>(scans.back().stamp_ns - scans[0].stamp_ns);
  EXPECT_NEAR(seconds / 411.0, 0.0977, 0.0005);
  EXPECT_TRUE(scans[0].has_doppler);
}

TEST(RealBags, TransformsOfBothGenerationsAreTheSame) {
  RADIVE_SKIP_WITHOUT("trajectories/containers");
  const auto folder = SharedData() / "trajectories" / "containers";
  std::string error;
  const auto ros1 = OpenMessageSource(folder / "tf_example.bag", BagFormat::kRosbag1, {}, &error);
  ASSERT_NE(ros1, nullptr) << error;
  const auto ros2 = OpenMessageSource(folder / "tf_example", BagFormat::kRosbag2, {}, &error);
  ASSERT_NE(ros2, nullptr) << error;
  const auto of_ros1 = testing::ReadMessages(ros1.get());
  const auto of_ros2 = testing::ReadMessages(ros2.get());
  ASSERT_EQ(of_ros1.size(), 518u);
  ASSERT_EQ(of_ros2.size(), 518u);
  for (std::size_t i = 0; i < of_ros1.size(); ++i) {
    EXPECT_EQ(of_ros1[i].topic, of_ros2[i].topic);
    EXPECT_EQ(of_ros1[i].record_ns, of_ros2[i].record_ns);
  }
  EXPECT_THAT(ErrorOf("trajectories/containers/tf_example.bag", InputOptions::Format::kRosbag1),
              AllOf(HasSubstr("has no point clouds"), HasSubstr("/tf (tf2_msgs/TFMessage, 517")));
  EXPECT_THAT(ErrorOf("trajectories/containers/tf_example", InputOptions::Format::kRosbag2),
              HasSubstr("/tf (tf2_msgs/msg/TFMessage, 517"));
}

TEST(RealBags, PacketsOfTheSensorAreRefusedByName) {
  RADIVE_SKIP_WITHOUT("ars548-nebula");
  const std::string expected =
      "/sensing/radar/front_center/nebula_packets (nebula_msgs/msg/NebulaPackets, 2 messages)";
  for (const char* place : {"ars548-nebula", "ars548-nebula/1708578204.db3"}) {
    EXPECT_THAT(ErrorOf(place, InputOptions::Format::kRosbag2),
                AllOf(HasSubstr("has no point clouds"), HasSubstr(expected)));
  }
}

}  // namespace
}  // namespace radive
