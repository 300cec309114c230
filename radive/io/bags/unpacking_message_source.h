// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "radive/io/bags/message_source.h"

namespace radive {

// Another source, with each payload unpacked that is a zstd frame: rosbag 2 in compression_mode
// MESSAGE, in whatever container. A frame is known by its first bytes, which no CDR message has, so
// that a file without its metadata.yaml can be read too.
class UnpackingMessageSource : public MessageSource {
 public:
  UnpackingMessageSource(std::unique_ptr<MessageSource> packed, const MessageLimits& limits);

  void Select(const std::vector<int>& topics) override { packed_->Select(topics); }
  Status Next(Message* message) override;
  std::int64_t start_ns() const override { return packed_->start_ns(); }
  std::string Description() const override { return packed_->Description(); }

 private:
  void TakeOverWarnings();
  bool Unpack(Message* message, std::string* reason);

  const std::unique_ptr<MessageSource> packed_;
  const MessageLimits limits_;
  std::string payload_;
};

}  // namespace radive
