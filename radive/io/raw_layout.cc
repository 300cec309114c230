// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/raw_layout.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "radive/io/text_lines.h"

namespace radive {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kNamedLayouts = {{
    {"xyz3", "x,y,z"},
    {"vod7", "x,y,z,rcs,v_r,_,_"},
    {"xyzdp5", "x,y,z,doppler,power"},
    {"tj4d8", "x,y,z,v_r,_,power,_,_"},
}};

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

bool IsOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Where `layout` keeps the column called `name`; null for a name that means nothing. Only whole
// names count: v_r_compensated or vx are no Doppler.
int* FindColumn(std::string_view name, RawLayout* layout) {
  if (name == "x") return &layout->x;
  if (name == "y") return &layout->y;
  if (name == "z") return &layout->z;
  if (IsOneOf(name,
              {"doppler",
               "v_doppler_mps",
               "velocity",
               "radial_velocity",
               "radial_speed",
               "v_r",
               "vr",
               "range_rate",
               "rangerate",
               "v",
               "vel",
               "speed"})) {
    return &layout->doppler;
  }
  if (IsOneOf(name, {"power", "snr_db", "snr", "intensity", "rcs", "reflectivity"})) {
    return &layout->power;
  }
  return nullptr;
}

}  // namespace

std::optional<RawLayout> ParseRawLayout(const std::string& text, std::string* error) {
  RawLayout layout;
  layout.name = text;
  std::string columns = LowerCase(TrimBlanks(text));
  for (const auto& [name, expansion] : kNamedLayouts) {
    if (columns == name) columns = expansion;
  }
  if (columns.size() >= 2 && columns.front() == '[' && columns.back() == ']') {
    columns = columns.substr(1, columns.size() - 2);
  }
  const std::string where = "layout " + Quoted(text);
  for (std::string_view rest = columns;; ++layout.num_columns) {
    const std::size_t comma = rest.find(',');
    const std::string_view name = TrimBlanks(rest.substr(0, comma));
    if (name != "_") {
      int* const column = FindColumn(name, &layout);
      if (column == nullptr) {
        *error = where +
                 ": expected xyz3, vod7, xyzdp5, tj4d8, or a list of the columns x, y, z, " +
                 "doppler, power and _ (to ignore one), found " + Quoted(name);
        return std::nullopt;
      }
      if (*column >= 0) {
        *error = where + ": column " + Quoted(name) + " says the same as column " +
                 std::to_string(*column + 1) + "; call one of them _ to ignore it";
        return std::nullopt;
      }
      *column = layout.num_columns;
    }
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  ++layout.num_columns;
  if (layout.x < 0 || layout.y < 0) {
    *error = where + ": must have the columns x and y";
    return std::nullopt;
  }
  return layout;
}

}  // namespace radive
