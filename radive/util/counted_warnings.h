// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace radive {

// Warnings of which there may be thousands, such as one for each message of a drive: the first of a
// kind is said at once, of the others only their number, at the end.
class CountedWarnings {
 public:
  // `kind` reads well behind "and 12 more: ".
  void Add(const std::string& kind, std::string text) {
    if (num_[kind]++ == 0) warnings_.push_back(std::move(text));
  }

  // Says how many there were of each kind beyond the first.
  void Finish() {
    for (auto& [kind, num] : num_) {
      if (num > 1) warnings_.push_back("and " + std::to_string(num - 1) + " more: " + kind);
      num = 1;
    }
  }

  // Those that were not taken yet.
  std::vector<std::string> Take() { return std::exchange(warnings_, {}); }

 private:
  std::map<std::string, int> num_;
  std::vector<std::string> warnings_;
};

}  // namespace radive
