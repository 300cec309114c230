// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "radive/io/bags/bag_source.h"
#include "radive/io/bags/mcap_writer.h"
#include "radive/io/bags/message_source.h"
#include "radive/io/bags/message_writer.h"
#include "radive/io/bags/point_cloud_encoding.h"
#include "radive/io/bags/ros1_bag_writer.h"
#include "radive/io/bags/sqlite_bag_writer.h"
#include "radive/util/random.h"

namespace radive::testing {

// A message that was read, with its own copy of the payload.
struct ReadMessage {
  std::string topic;
  std::int64_t record_ns = 0;
  std::string payload;
  bool operator==(const ReadMessage& other) const {
    return topic == other.topic && record_ns == other.record_ns && payload == other.payload;
  }
};

// Every message of all topics, or of those in `topics`; the source must end without an error.
inline std::vector<ReadMessage> ReadMessages(MessageSource* source,
                                             const std::vector<std::string>& topics = {}) {
  std::vector<int> wanted;
  for (std::size_t i = 0; i < source->topics().size(); ++i) {
    bool is_wanted = topics.empty();
    for (const std::string& topic : topics) {
      is_wanted = is_wanted || source->topics()[i].name == topic;
    }
    if (is_wanted) wanted.push_back(static_cast<int>(i));
  }
  source->Select(wanted);
  std::vector<ReadMessage> messages;
  Message message;
  MessageSource::Status status;
  while ((status = source->Next(&message)) == MessageSource::Status::kMessage) {
    messages.push_back({source->topics()[static_cast<std::size_t>(message.topic)].name,
                        message.record_ns,
                        std::string(message.payload)});
  }
  EXPECT_EQ(status, MessageSource::Status::kEnd) << source->error();
  return messages;
}

// Scans at 10 Hz from stamp 0 with a few returns each, the second one empty. All values are float32
// numbers, so that they come back as they are.
inline std::vector<RadarScan> MadeScans(int num_scans, int num_returns = 5) {
  Random random(7);
  std::vector<RadarScan> scans(static_cast<std::size_t>(num_scans));
  const auto number = [&] { return static_cast<float>(random.Normal()); };
  for (int k = 0; k < num_scans; ++k) {
    RadarScan& scan = scans[static_cast<std::size_t>(k)];
    scan.stamp_ns = k * std::int64_t{100000000};
    for (int i = 0; i < (k == 1 ? 0 : num_returns); ++i) {
      RadarReturn& added = scan.returns.emplace_back();
      for (int axis = 0; axis < 3; ++axis) added.position[axis] = 8.0 * number();
      added.doppler = number();
      added.power = number();
    }
  }
  return scans;
}

// A form in which a drive is written.
struct BagForm {
  std::string name;  // of the file or folder, and of the test
  BagFormat format;
  Compression compression = Compression::kNone;
  bool index = true;
  std::size_t chunk_size = 1000;  // [bytes]: some chunks for a few scans
};

// For the names of parametrised tests, which would show the object's bytes.
inline void PrintTo(const BagForm& form, std::ostream* stream) { *stream << form.name; }

inline std::vector<BagForm> AllBagForms() {
  return {
      {"ros1_none.bag", BagFormat::kRosbag1},
      {"ros1_bz2.bag", BagFormat::kRosbag1, Compression::kBz2},
      {"ros1_lz4.bag", BagFormat::kRosbag1, Compression::kLz4},
      {"ros1_none_unindexed.bag", BagFormat::kRosbag1, Compression::kNone, false},
      {"ros1_bz2_unindexed.bag", BagFormat::kRosbag1, Compression::kBz2, false},
      {"ros1_lz4_unindexed.bag", BagFormat::kRosbag1, Compression::kLz4, false},
      {"rosbag2_none", BagFormat::kRosbag2},
      {"rosbag2_zstd", BagFormat::kRosbag2, Compression::kZstd},
      {"mcap_none.mcap", BagFormat::kMcap},
      {"mcap_lz4.mcap", BagFormat::kMcap, Compression::kLz4},
      {"mcap_zstd.mcap", BagFormat::kMcap, Compression::kZstd},
      {"mcap_none_unindexed.mcap", BagFormat::kMcap, Compression::kNone, false},
      {"mcap_lz4_unindexed.mcap", BagFormat::kMcap, Compression::kLz4, false},
      {"mcap_zstd_unindexed.mcap", BagFormat::kMcap, Compression::kZstd, false},
  };
}

inline std::unique_ptr<MessageWriter> OpenWriter(const std::filesystem::path& path,
                                                 const BagForm& form) {
  std::string error;
  std::unique_ptr<MessageWriter> writer;
  if (form.format == BagFormat::kRosbag1) {
    writer = Ros1BagWriter::Create(path, {form.compression, form.index, form.chunk_size}, &error);
  } else if (form.format == BagFormat::kMcap) {
    writer = McapWriter::Create(path, {form.compression, form.index, form.chunk_size}, &error);
  } else {
    writer = SqliteBagWriter::Create(path, {form.compression == Compression::kZstd}, &error);
  }
  EXPECT_NE(writer, nullptr) << error;
  return writer;
}

inline MessageTopic CloudTopic(const BagForm& form, const std::string& name = "/radar") {
  const bool is_ros1 = form.format == BagFormat::kRosbag1;
  return {name,
          is_ros1 ? "sensor_msgs/PointCloud2" : "sensor_msgs/msg/PointCloud2",
          is_ros1 ? "ros1" : "cdr",
          {}};
}

// Writes the scans to /radar, each recorded 5 ms after its stamp, and between them messages of
// another topic and type.
inline void WriteBag(const std::filesystem::path& path,
                     const BagForm& form,
                     const std::vector<RadarScan>& scans) {
  const std::unique_ptr<MessageWriter> writer = OpenWriter(path, form);
  const MessageTopic cloud = CloudTopic(form);
  const int clouds = writer->AddTopic(cloud);
  const int others = writer->AddTopic({"/imu", "sensor_msgs/Imu", cloud.encoding, {}});
  std::string error;
  for (const RadarScan& scan : scans) {
    const std::string payload = EncodePointCloud2(scan, cloud.encoding, "radar");
    EXPECT_TRUE(writer->Write(others, scan.stamp_ns + 1000000, std::string(300, 'i'), &error));
    EXPECT_TRUE(writer->Write(clouds, scan.stamp_ns + 5000000, payload, &error)) << error;
  }
  EXPECT_TRUE(writer->Close(&error)) << error;
}

// Stamps, positions, Doppler and power are the same numbers.
inline void ExpectSameScans(const std::vector<RadarScan>& actual,
                            const std::vector<RadarScan>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_EQ(actual[k].stamp_ns, expected[k].stamp_ns);
    ASSERT_EQ(actual[k].returns.size(), expected[k].returns.size()) << "scan " << k;
    for (std::size_t i = 0; i < expected[k].returns.size(); ++i) {
      EXPECT_EQ(actual[k].returns[i].position, expected[k].returns[i].position);
      EXPECT_EQ(actual[k].returns[i].doppler, expected[k].returns[i].doppler);
      EXPECT_EQ(actual[k].returns[i].power, expected[k].returns[i].power);
    }
  }
}

}  // namespace radive::testing
