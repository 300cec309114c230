// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "radive/io/bags/bag_trajectory.h"

// The first byte says which message the others are.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::array<radive::MessageTopic, 6> kTopics = {{
      {"/a", "geometry_msgs/PoseStamped", "ros1", {}},
      {"/a", "nav_msgs/Odometry", "ros1", {}},
      {"/a", "sensor_msgs/NavSatFix", "ros1", {}},
      {"/a", "geometry_msgs/msg/PoseStamped", "cdr", {}},
      {"/a", "nav_msgs/msg/Odometry", "cdr", {}},
      {"/a", "sensor_msgs/msg/NavSatFix", "cdr", {}},
  }};
  if (size == 0) return 0;
  const std::string_view payload(reinterpret_cast<const char*>(data) + 1, size - 1);
  radive::PoseMessage message;
  if (radive::ReadPoseMessage(payload, kTopics[data[0] % kTopics.size()], &message) &&
      message.has_fix && !message.pose.T_world_body.translation.allFinite()) {
    std::abort();
  }
  return 0;
}
