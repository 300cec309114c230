// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace radive {

// `text` without blanks and tabs at both ends.
inline std::string_view TrimBlanks(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

// `text` cut to a length that fits in a message, without control characters.
inline std::string Quoted(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string quoted = "'";
  for (const char c : text.substr(0, kLongest)) quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + (text.size() > kLongest ? "...'" : "'");
}

// ASCII letters in lower case, the rest as it is.
inline std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

// `text` without the UTF-8 byte order mark that editors of Windows put in front.
inline std::string_view WithoutByteOrderMark(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  return text.substr(0, kByteOrderMark.size()) == kByteOrderMark
             ? text.substr(kByteOrderMark.size())
             : text;
}

// The lines of a text one by one, with their numbers. Line ends are LF or CRLF, or CR where there
// is no LF, as old programs for the Mac write them; the last may be missing; a UTF-8 byte order
// mark in front is dropped. Holds a view: the text must outlive it.
class TextLines {
 public:
  explicit TextLines(std::string_view text)
      : rest_(WithoutByteOrderMark(text)),
        line_end_(rest_.find('\n') == std::string_view::npos ? '\r' : '\n') {}

  // False at the end of the text.
  bool Next(std::string_view* line) {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find(line_end_);
    *line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (!line->empty() && line->back() == '\r') line->remove_suffix(1);
    ++number_;
    return true;
  }

  // Of the line that Next() gave last, from 1.
  int number() const { return number_; }

 private:
  std::string_view rest_;
  char line_end_;
  int number_ = 0;
};

}  // namespace radive
