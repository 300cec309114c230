// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "radive/util/stopwatch.h"

namespace radive {

// One line on how far a job is: "[=====>    ]  123/396 scans  45.2 scans/s  ETA 0:06", without bar
// and ETA where the total is not known. `elapsed` is in seconds, `unit` is what is counted.
std::string ProgressLine(int done,
                         std::optional<int> total,
                         double elapsed,
                         const std::string& unit = "scans");

// Shows the progress of a job over scans, or over what `unit` says: a bar that redraws itself on a
// terminal, otherwise a line every few seconds, so that logs stay short. Also prints messages
// without tearing the bar.
class Progress {
 public:
  enum class Mode { kBar, kLines, kQuiet };

  // kBar when `stream` is a terminal, else kLines.
  static Mode ModeFor(std::FILE* stream);

  Progress(std::FILE* stream, Mode mode, std::optional<int> total, std::string unit = "scans")
      : stream_(stream), mode_(mode), total_(total), unit_(std::move(unit)) {}

  // Call after each scan.
  void Update(int done);

  // A line of its own; nothing when quiet.
  void Message(const std::string& text);

  // The last state, and a line end behind the bar.
  void Finish();

 private:
  void Draw(double elapsed);

  std::FILE* const stream_;
  const Mode mode_;
  const std::optional<int> total_;
  const std::string unit_;
  const Stopwatch stopwatch_;
  int done_ = 0;
  double last_draw_ = 0.0;      // [s] since the start
  std::size_t bar_length_ = 0;  // characters on the terminal's current line
};

}  // namespace radive
