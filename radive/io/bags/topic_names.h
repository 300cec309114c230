// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/io/bags/message_source.h"

namespace radive {

// For messages: "/tf (tf2_msgs/TFMessage, 517 messages)".
std::string NameOf(const MessageTopic& topic);

// These, with commas between them.
std::string NamesOf(const std::vector<MessageTopic>& topics);

}  // namespace radive
