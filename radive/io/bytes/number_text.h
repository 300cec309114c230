// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

#include "radive/util/number_text.h"

namespace radive {

// Takes the next word, up to blanks, tabs or line ends, off the front of `text`; empty when there
// is none left.
inline std::string_view TakeWord(std::string_view* text) {
  constexpr std::string_view kBlanks = " \t\r\n\v\f";
  const std::size_t begin = text->find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) {
    *text = {};
    return {};
  }
  text->remove_prefix(begin);
  const std::string_view word = text->substr(0, text->find_first_of(kBlanks));
  text->remove_prefix(word.size());
  return word;
}

}  // namespace radive
