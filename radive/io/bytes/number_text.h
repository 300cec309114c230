// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

#include "radive/util/number_text.h"

namespace radive {

// Takes the next word, up to blanks, tabs or line ends, off the front of `text`; empty when there
// is none left.
inline std::string_view TakeWord(std::string_view* text) {
  // By comparisons: the searches of the standard library make a call for each character.
  const auto is_blank = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  std::size_t begin = 0;
  while (begin < text->size() && is_blank((*text)[begin])) ++begin;
  std::size_t end = begin;
  while (end < text->size() && !is_blank((*text)[end])) ++end;
  const std::string_view word = text->substr(begin, end - begin);
  text->remove_prefix(end);
  return word;
}

}  // namespace radive
