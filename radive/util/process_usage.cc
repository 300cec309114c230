// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/process_usage.h"

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

#include "radive/util/number_text.h"

namespace radive {

double CpuSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double PeakMemoryMegabytes() {
  // getrusage would report the parent's peak when that was larger at the time of the fork.
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmHWM:", 0) != 0) continue;
    const std::size_t begin = std::min(line.find_first_of("0123456789"), line.size());
    const std::size_t end = line.find_first_not_of("0123456789", begin);
    if (const auto kilobytes = ParseCount(std::string_view(line).substr(begin, end - begin))) {
      return static_cast<double>(*kilobytes) * 1024 / 1e6;
    }
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
}

}  // namespace radive
