// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// A value as it was written, before it is known which field it is for.
struct SettingText {
  bool is_list = false;
  bool is_quoted = false;          // "..." or '...': a string, never a number
  std::vector<std::string> words;  // one, unless is_list

  // As a person would write it: 3, [1, 2, 3].
  std::string ToString() const;
};

// Reads the text after the '=' of --set: 3, true, paper, "two words", [1, 2.5, 3].
SettingText ParseSettingText(const std::string& text);

// Writes `text` into the variable behind `field`. A value of the wrong type or out of the field's
// bounds leaves "STAGE.FIELD must be RULE, is VALUE" in `error`.
bool AssignField(const std::string& stage,
                 const SettingText& text,
                 OptionField* field,
                 std::string* error);

// The candidate with the fewest typing errors between it and `word`; none when all are far off.
std::optional<std::string> NearestWord(const std::string& word,
                                       const std::vector<std::string>& candidates);

}  // namespace radive
