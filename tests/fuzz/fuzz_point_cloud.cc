// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/bags/point_cloud_messages.h"
#include "radive/io/scans/point_converter.h"

// The first byte says which message the others are.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::array<radive::MessageTopic, 4> kTopics = {{
      {"/a", "sensor_msgs/PointCloud2", "ros1", {}},
      {"/a", "sensor_msgs/msg/PointCloud2", "cdr", {}},
      {"/a", "sensor_msgs/PointCloud", "ros1", {}},
      {"/a", "sensor_msgs/msg/PointCloud", "cdr", {}},
  }};
  if (size == 0) return 0;
  const radive::MessageTopic& topic = kTopics[data[0] % kTopics.size()];
  const std::string_view payload(reinterpret_cast<const char*>(data) + 1, size - 1);
  std::int64_t stamp_ns = 0;
  radive::PointTable table;
  radive::RadarScan scan;
  std::vector<std::string> remarks;
  std::string error;
  radive::ReadPointCloudStamp(payload, topic, &stamp_ns);
  if (radive::ReadPointCloud(payload, topic, &table, &remarks, &error)) {
    radive::PointConverter(radive::InputOptions()).Convert(table, &scan, &error);
  }
  return 0;
}
