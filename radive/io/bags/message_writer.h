// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "radive/io/bags/message_source.h"

namespace radive {

// A bag that is written, in any container. A writer that is destroyed before Close() leaves a file
// without its index, as a recorder that crashes does.
//
//   const int topic = writer->AddTopic({"/radar", "sensor_msgs/msg/PointCloud2", "cdr", {}});
//   for (...) if (!writer->Write(topic, stamp_ns, payload, &error)) return false;
//   return writer->Close(&error);
class MessageWriter {
 public:
  virtual ~MessageWriter() = default;

  // Makes a topic known and returns its number, for Write().
  virtual int AddTopic(const MessageTopic& topic) = 0;

  // Appends a message that was recorded at `record_ns` >= 0. False, with the file and the reason
  // in `error`, when it cannot be written.
  virtual bool Write(int topic,
                     std::int64_t record_ns,
                     std::string_view payload,
                     std::string* error) = 0;

  // Writes what is left and the index. Nothing can be written any more.
  virtual bool Close(std::string* error) = 0;
};

}  // namespace radive
