// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

#include "radive/io/bytes/text_lines.h"

namespace radive {

// Whether the messages of a topic are all of one frame: two sensors that share a topic would be
// taken for one that jumps to and fro.
class FrameWatch {
 public:
  // What is to be said of the next message; empty: nothing. A frame without a name says nothing.
  std::string Look(std::string_view frame_id) {
    if (!frame_id.empty() && frame_id.front() == '/') frame_id.remove_prefix(1);
    if (first_.empty()) first_ = frame_id;
    if (frame_id.empty() || frame_id == first_) return "";
    return "the frame is " + Quoted(frame_id) + ", that of the first was " + Quoted(first_) +
           "; all are taken as scans of one radar";
  }

 private:
  std::string first_;
};

}  // namespace radive
