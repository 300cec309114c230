// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radive/util/counted_warnings.h"

namespace radive {

// A named stream of messages of one type in a bag.
struct MessageTopic {
  std::string name;      // "/radar/points"
  std::string type;      // as the bag has it: "sensor_msgs/PointCloud2", "sensor_msgs/msg/Imu"
  std::string encoding;  // "ros1", "cdr", or what else the bag says
  std::optional<std::uint64_t> num_messages;
};

struct Message {
  int topic = 0;               // index in MessageSource::topics()
  std::int64_t record_ns = 0;  // when it was recorded [ns]
  std::string_view payload;    // the serialised message; valid until the next call of Next()
};

// Bounds on what a bag may make its reader allocate [bytes].
struct MessageLimits {
  // Payload of one message.
  std::uint64_t message = std::uint64_t{256} << 20;

  // Of what a chunk is decompressed to: recorders close a chunk behind the message that makes it
  // larger than a few MiB.
  std::uint64_t Chunk() const { return message + (std::uint64_t{32} << 20); }
};

// A bag, message by message, in the order of recording. What all containers have in common.
//
//   source->Select({index of the topic});
//   Message message;
//   while (source->Next(&message) == MessageSource::Status::kMessage) { ... }
class MessageSource {
 public:
  enum class Status {
    kMessage,
    kEnd,
    kError,  // the bag cannot be read any further: error() says file, place and expectation
  };

  virtual ~MessageSource() = default;

  const std::vector<MessageTopic>& topics() const { return topics_; }

  // Which topics Next() gives: none at first. Only before the first Next(). The messages of the
  // others are passed over, without reading them where the container allows it.
  virtual void Select(const std::vector<int>& topics) = 0;

  // The next message of the selected topics, in record-time order; messages of the same time in
  // the order of the files and of the places in them.
  virtual Status Next(Message* message) = 0;

  // No message was recorded earlier than this [ns].
  virtual std::int64_t start_ns() const = 0;

  // "ROS 1 bag FILE".
  virtual std::string Description() const = 0;

  // Set after Status::kError.
  const std::string& error() const { return error_; }

  // What was passed over or cut, since the last call.
  std::vector<std::string> TakeWarnings() { return warnings_.Take(); }

 protected:
  std::vector<MessageTopic> topics_;
  std::string error_;
  CountedWarnings warnings_;
};

}  // namespace radive
