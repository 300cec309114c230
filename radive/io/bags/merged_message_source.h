// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "radive/io/bags/message_source.h"

namespace radive {

// The files of a split bag as one: messages in record-time order. A file is not read before its
// time has come, and is closed behind its last message.
class MergedMessageSource : public MessageSource {
 public:
  // `parts` are at least one, in the order of their names; `description` for Description().
  MergedMessageSource(std::vector<std::unique_ptr<MessageSource>> parts, std::string description);

  void Select(const std::vector<int>& topics) override;
  Status Next(Message* message) override;
  std::int64_t start_ns() const override { return start_ns_; }
  std::string Description() const override { return description_; }

 private:
  struct Part {
    std::unique_ptr<MessageSource> source;  // null: over
    std::int64_t start_ns = 0;
    std::vector<int> merged_topic;  // by topic of the part
    bool has_message = false;
    Message message;  // the next one, where there is one
  };

  bool Advance(Part* part);

  const std::string description_;
  std::vector<Part> parts_;
  std::int64_t start_ns_ = 0;
  Part* given_ = nullptr;  // whose message was given last
};

}  // namespace radive
