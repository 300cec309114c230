// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/trajectories/pose_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>

#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

// A name in lower case with _ between its parts, and the unit in brackets behind it.
struct Name {
  std::string text;
  std::string unit;
};

bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

Name NormalName(std::string_view raw) {
  std::string text = LowerCase(raw);
  Name name;
  if (const std::size_t begin = text.find_first_of("[("); begin != std::string::npos) {
    const std::size_t end = text.find_last_of("])");
    if (end != std::string::npos && end > begin) {
      name.unit = TrimBlanks(std::string_view(text).substr(begin + 1, end - begin - 1));
    }
    text.resize(begin);
  }
  for (const char c : text) {
    if (c == '#' || c == '%' || c == '"' || c == '\'') continue;
    const bool is_separator = c == '.' || c == '/' || c == ' ' || c == '\t' || c == '-' || c == ':';
    if (is_separator && (name.text.empty() || name.text.back() == '_')) continue;
    name.text += is_separator ? '_' : c;
  }
  while (!name.text.empty() && name.text.back() == '_') name.text.pop_back();
  return name;
}

using NameList = std::vector<Name>;

// The first column with one of `names`, or one that ends in _ and one of `ends`; -1: none.
int Find(const NameList& columns,
         const std::vector<std::string>& names,
         const std::vector<std::string>& ends = {}) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string& text = columns[i].text;
    const auto is_it = [&](const std::string& name) { return text == name; };
    const auto is_end = [&](const std::string& end) {
      return text == end || EndsWith(text, "_" + end);
    };
    if (std::any_of(names.begin(), names.end(), is_it) ||
        std::any_of(ends.begin(), ends.end(), is_end)) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

template <std::size_t kSize>
bool AreThere(const std::array<int, kSize>& columns) {
  return std::all_of(columns.begin(), columns.end(), [](int column) { return column >= 0; });
}

// Exponent of ten of a unit of time; nothing for other words.
std::optional<int> TimeExponent(std::string_view unit) {
  if (unit == "s" || unit == "sec" || unit == "secs" || unit == "seconds") return 0;
  if (unit == "ms" || unit == "msec" || unit == "milliseconds") return -3;
  if (unit == "us" || unit == "usec" || unit == "microseconds") return -6;
  if (unit == "ns" || unit == "nsec" || unit == "nsecs" || unit == "nanosec" ||
      unit == "nanoseconds") {
    return -9;
  }
  return std::nullopt;
}

// "timestamp_us" -> "timestamp" and -6.
std::optional<int> TakeTimeUnit(Name* name) {
  if (!name->unit.empty()) return TimeExponent(name->unit);
  const std::size_t end = name->text.rfind('_');
  if (end == std::string::npos) return std::nullopt;
  const std::optional<int> exponent = TimeExponent(std::string_view(name->text).substr(end + 1));
  if (exponent) name->text.resize(end);
  return exponent;
}

void FindStamp(const NameList& names, PoseColumns* columns) {
  const int seconds = Find(names, {"sec", "secs", "seconds"}, {"stamp_sec", "stamp_secs"});
  const int nanoseconds = Find(names,
                               {"nsec", "nsecs", "nanosec", "nanosecs", "nanoseconds"},
                               {"stamp_nsec", "stamp_nsecs", "stamp_nanosec"});
  if (seconds >= 0 && nanoseconds >= 0) {
    columns->stamp = seconds;
    columns->nanoseconds = nanoseconds;
    return;
  }
  NameList without_units = names;
  std::vector<std::optional<int>> exponents;
  for (Name& name : without_units) exponents.push_back(TakeTimeUnit(&name));
  columns->stamp = Find(without_units,
                        {"timestamp", "timestamps", "time", "t", "stamp", "rostime"},
                        {"header_stamp"});
  if (columns->stamp < 0) columns->stamp = seconds;
  if (columns->stamp < 0) return;
  const std::optional<int> exponent = exponents[static_cast<std::size_t>(columns->stamp)];
  columns->stamp_exponent = exponent.value_or(0);
  columns->has_stamp_unit = exponent.has_value();
}

// Rotation matrices count from 0 or from 1.
void FindMatrix(const NameList& names, PoseColumns* columns) {
  for (const int first : {0, 1}) {
    std::array<int, 9> found;
    for (int i = 0; i < 9; ++i) {
      const std::string cell = std::to_string(first + i / 3) + std::to_string(first + i % 3);
      found[static_cast<std::size_t>(i)] = Find(names, {"r" + cell, "r_" + cell});
    }
    if (!AreThere(found)) continue;
    for (std::size_t i = 0; i < 9; ++i) columns->matrix[4 * (i / 3) + i % 3] = found[i];
    for (std::size_t row = 0; row < 3; ++row) {
      columns->matrix[4 * row + 3] = columns->position[row];
    }
    return;
  }
}

void FindAngles(NameList names, PoseColumns* columns) {
  std::string unit;
  for (Name& name : names) {
    for (const char* end : {"deg", "rad"}) {
      if (!EndsWith(name.text, std::string("_") + end)) continue;
      name.unit = end;
      name.text.resize(name.text.size() - 4);
    }
  }
  columns->angles = {
      Find(names, {}, {"roll"}), Find(names, {}, {"pitch"}), Find(names, {}, {"yaw"})};
  if (!AreThere(columns->angles)) {
    columns->angles = {-1, -1, -1};
    return;
  }
  unit = names[static_cast<std::size_t>(columns->angles[2])].unit;
  if (unit.substr(0, 3) == "deg" || unit == "\xC2\xB0" || unit == "\xB0") {
    columns->angle_unit = kRadiansPerDegree;
  }
}

}  // namespace

std::vector<std::string_view> SplitNames(std::string_view line) {
  line = TrimBlanks(line);
  std::vector<std::string_view> names;
  for (const char delimiter : {';', ',', '\t'}) {
    if (line.find(delimiter) == std::string_view::npos) continue;
    for (;;) {
      const std::size_t end = line.find(delimiter);
      names.push_back(TrimBlanks(line.substr(0, end)));
      if (end == std::string_view::npos) return names;
      line.remove_prefix(end + 1);
    }
  }
  while (!line.empty()) {
    std::size_t end = std::min(line.find(' '), line.size());
    const std::size_t next = line.find_first_not_of(' ', end);
    if (next != std::string_view::npos && (line[next] == '[' || line[next] == '(')) {
      end = std::min(line.find_first_of("])", next), line.size() - 1) + 1;
    }
    // A sign of a comment may stand apart.
    const std::string_view name = line.substr(0, end);
    if (name != "#" && name != "%") names.push_back(name);
    line = TrimBlanks(line.substr(end));
  }
  return names;
}

std::optional<PoseColumns> ColumnsByName(const std::vector<std::string_view>& raw_names) {
  NameList names;
  for (const std::string_view name : raw_names) names.push_back(NormalName(name));
  PoseColumns columns;
  FindStamp(names, &columns);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    columns.position[i] = Find(names,
                               {axis,
                                "t" + axis,
                                "p" + axis,
                                "p_" + axis,
                                "t_" + axis,
                                "pos_" + axis,
                                axis + "_m",
                                "p_rs_r_" + axis},
                               {"position_" + axis, "translation_" + axis});
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string axis(1, "xyzw"[i]);
    columns.quaternion[i] =
        Find(names,
             {"q" + axis, "q_" + axis, "q_rs_" + axis, "o" + axis},
             {"orientation_" + axis, "quaternion_" + axis, "quat_" + axis, "rotation_" + axis});
  }
  if (!AreThere(columns.position)) return std::nullopt;
  if (AreThere(columns.quaternion)) return columns;
  columns.quaternion = {-1, -1, -1, -1};
  FindMatrix(names, &columns);
  if (AreThere(columns.matrix)) return columns;
  FindAngles(std::move(names), &columns);
  return AreThere(columns.angles) ? std::optional(columns) : std::nullopt;
}

}  // namespace radive
