// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/unpacking_message_source.h"

#include <zstd.h>

#include <string_view>
#include <utility>

#include "radive/io/bytes/compression.h"

namespace radive {
namespace {

constexpr std::string_view kZstdMagic("\x28\xB5\x2F\xFD", 4);

}  // namespace

UnpackingMessageSource::UnpackingMessageSource(std::unique_ptr<MessageSource> packed,
                                               const MessageLimits& limits)
    : packed_(std::move(packed)), limits_(limits) {
  topics_ = packed_->topics();
  TakeOverWarnings();
}

void UnpackingMessageSource::TakeOverWarnings() {
  for (std::string& warning : packed_->TakeWarnings()) {
    const std::string kind = warning;  // the source counts its own
    warnings_.Add(kind, std::move(warning));
  }
}

bool UnpackingMessageSource::Unpack(Message* message, std::string* reason) {
  const std::uint64_t size =
      ZSTD_getFrameContentSize(message->payload.data(), message->payload.size());
  if (size > limits_.message) {  // or unknown, which is larger than any
    *reason = "its zstd frame says no size, or one above input.max_message_bytes";
    return false;
  }
  if (!Decompress(Compression::kZstd, message->payload, size, &payload_, reason)) return false;
  message->payload = payload_;
  return true;
}

MessageSource::Status UnpackingMessageSource::Next(Message* message) {
  for (;;) {
    const Status status = packed_->Next(message);
    TakeOverWarnings();
    if (status == Status::kError) error_ = packed_->error();
    if (status == Status::kEnd) warnings_.Finish();
    if (status != Status::kMessage) return status;
    const MessageTopic& topic = topics_[static_cast<std::size_t>(message->topic)];
    if (topic.encoding != "cdr" || message->payload.substr(0, 4) != kZstdMagic) return status;
    std::string reason;
    if (Unpack(message, &reason)) return status;
    warnings_.Add("packed messages in " + Description(),
                  Description() + ": the message of " + topic.name + " recorded at " +
                      std::to_string(message->record_ns) + " ns cannot be unpacked: " + reason +
                      "; it is passed over");
  }
}

}  // namespace radive
