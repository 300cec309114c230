// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace radive {

// Tells from the times of recording, in the order in which the messages lie in a file, whether the
// clock of the recorder was set back while it recorded. The order of the file is then that of the
// drive; otherwise it is that of the times, because files may hold a topic after the other, or
// parts that were joined in any order.
class RecordClock {
 public:
  void Add(std::uint64_t topic, std::int64_t record_ns) {
    std::vector<Part>& parts = parts_[topic];
    if (parts.empty() || IsFarBefore(record_ns, parts.back().last_ns)) parts.emplace_back();
    parts.back().first_ns = std::min(parts.back().first_ns, record_ns);
    parts.back().last_ns = std::max(parts.back().last_ns, record_ns);
  }

  // True when the times of a topic go back by more than kStep, and what follows does not just end
  // where what was before begins, as with parts that were joined.
  bool WasSetBack() const {
    for (const auto& [topic, parts] : parts_) {
      for (std::size_t i = 1; i < parts.size(); ++i) {
        const bool is_before = parts[i].last_ns <= parts[i - 1].first_ns;
        if (!is_before || IsFarBefore(parts[i].last_ns, parts[i - 1].first_ns)) return true;
      }
    }
    return false;
  }

 private:
  struct Part {
    std::int64_t first_ns = std::numeric_limits<std::int64_t>::max();
    std::int64_t last_ns = std::numeric_limits<std::int64_t>::min();
  };
  static constexpr std::int64_t kStep = 2'000'000'000;  // [ns]; recorders mix up less than that

  static bool IsFarBefore(std::int64_t time_ns, std::int64_t other_ns) {
    return time_ns < std::numeric_limits<std::int64_t>::max() - kStep && time_ns + kStep < other_ns;
  }

  std::map<std::uint64_t, std::vector<Part>> parts_;
};

}  // namespace radive
