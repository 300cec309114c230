// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bags/topic_names.h"

#include <algorithm>
#include <cstddef>

namespace radive {

std::string NameOf(const MessageTopic& topic) {
  std::string text = topic.name + " (" + topic.type;
  if (topic.num_messages) text += ", " + std::to_string(*topic.num_messages) + " messages";
  return text + ")";
}

std::string NamesOf(const std::vector<MessageTopic>& topics) {
  constexpr std::size_t kMostNames = 50;
  std::string names;
  for (std::size_t i = 0; i < std::min(topics.size(), kMostNames); ++i) {
    names += (i == 0 ? "" : ", ") + NameOf(topics[i]);
  }
  if (topics.size() > kMostNames) names += ", ...";
  return topics.empty() ? "no topics" : names;
}

}  // namespace radive
