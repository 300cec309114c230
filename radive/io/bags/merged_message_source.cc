// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/merged_message_source.h"

#include <glog/logging.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace radive {

MergedMessageSource::MergedMessageSource(std::vector<std::unique_ptr<MessageSource>> parts,
                                         std::string description)
    : description_(std::move(description)), start_ns_(std::numeric_limits<std::int64_t>::max()) {
  CHECK(!parts.empty());
  for (std::unique_ptr<MessageSource>& source : parts) {
    Part& part = parts_.emplace_back();
    part.start_ns = source->start_ns();
    start_ns_ = std::min(start_ns_, part.start_ns);
    for (const MessageTopic& topic : source->topics()) {
      const auto is_same = [&](const MessageTopic& other) {
        return other.name == topic.name && other.type == topic.type &&
               other.encoding == topic.encoding;
      };
      const auto found = std::find_if(topics_.begin(), topics_.end(), is_same);
      part.merged_topic.push_back(static_cast<int>(found - topics_.begin()));
      if (found == topics_.end()) {
        topics_.push_back(topic);
      } else if (found->num_messages && topic.num_messages) {
        *found->num_messages += *topic.num_messages;
      } else {
        found->num_messages.reset();
      }
    }
    part.source = std::move(source);
  }
}

void MergedMessageSource::Select(const std::vector<int>& topics) {
  for (Part& part : parts_) {
    std::vector<int> of_part;
    for (std::size_t i = 0; i < part.merged_topic.size(); ++i) {
      if (std::find(topics.begin(), topics.end(), part.merged_topic[i]) != topics.end()) {
        of_part.push_back(static_cast<int>(i));
      }
    }
    part.source->Select(of_part);
  }
}

// False when the part cannot be read any further.
bool MergedMessageSource::Advance(Part* part) {
  const Status status = part->source->Next(&part->message);
  for (std::string& warning : part->source->TakeWarnings()) {
    const std::string kind = warning;  // the parts count theirs themselves
    warnings_.Add(kind, std::move(warning));
  }
  part->has_message = status == Status::kMessage;
  if (status == Status::kError) error_ = part->source->error();
  if (status == Status::kEnd) part->source.reset();
  return status != Status::kError;
}

MessageSource::Status MergedMessageSource::Next(Message* message) {
  if (given_ != nullptr && !Advance(given_)) return Status::kError;
  given_ = nullptr;
  for (;;) {
    Part* first = nullptr;
    const auto time_of = [](const Part& part) {
      return part.has_message ? part.message.record_ns : part.start_ns;
    };
    for (Part& part : parts_) {
      if (part.source != nullptr && (first == nullptr || time_of(part) < time_of(*first))) {
        first = &part;
      }
    }
    if (first == nullptr) {
      warnings_.Finish();
      return Status::kEnd;
    }
    if (first->has_message) {
      *message = first->message;
      message->topic = first->merged_topic[static_cast<std::size_t>(first->message.topic)];
      given_ = first;
      return Status::kMessage;
    }
    if (!Advance(first)) return Status::kError;
  }
}

}  // namespace radive
