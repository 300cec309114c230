// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/foreign_files.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace radive {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// The name with # for each number: "scan_12.csv" -> "scan_#.csv". Numbers with a point or a line in
// between are one.
std::string Pattern(const std::string& name) {
  std::string pattern;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (!IsDigit(name[i])) {
      const bool is_within = (name[i] == '.' || name[i] == '_') && i > 0 && IsDigit(name[i - 1]) &&
                             i + 1 < name.size() && IsDigit(name[i + 1]);
      if (!is_within) pattern += name[i];
    } else if (pattern.empty() || pattern.back() != '#') {
      pattern += '#';
    }
  }
  return pattern;
}

}  // namespace

std::vector<std::string> TakeOutForeign(const HoldsPointsTest& holds_points,
                                        std::vector<std::string>* names) {
  if (names->size() < 2) return {};
  std::map<std::string, std::size_t> counts;
  for (const std::string& name : *names) ++counts[Pattern(name)];
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& one, const auto& other) {
        return one.second < other.second;
      });
  const std::string usual = most->second >= 2 ? most->first : "";
  const bool is_usual = most->second >= 2 && 2 * most->second >= names->size();
  std::vector<std::string> scans, foreign;
  for (std::string& name : *names) {
    const std::string pattern = Pattern(name);
    bool is_scan = pattern == usual;
    if (!is_scan) {
      const bool has_number = pattern.find('#') != std::string::npos;
      is_scan = (has_number || !is_usual) && (!holds_points || holds_points(name));
    }
    (is_scan ? scans : foreign).push_back(std::move(name));
  }
  *names = std::move(scans);
  return foreign;
}

}  // namespace radive
