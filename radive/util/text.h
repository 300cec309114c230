// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace radive {

// `text` with every `what`, which is not empty, replaced by `with`.
inline std::string ReplaceAll(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

inline bool StartsWith(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

inline bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// The beginning of `text` as a message may show it: cut, and without control characters.
inline std::string Excerpt(std::string_view text, std::size_t longest = 60) {
  std::string excerpt(text.substr(0, longest));
  for (char& c : excerpt) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
  }
  return text.size() > longest ? excerpt + "..." : excerpt;
}

}  // namespace radive
