// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr int kBarWidth = 30;
constexpr double kBarInterval = 0.1;   // between two drawings of the bar [s]
constexpr double kLineInterval = 5.0;  // between two lines of a log [s]

// 3725 s -> "1:02:05", 65 s -> "1:05".
std::string ClockText(double seconds) {
  const long total = std::lround(std::ceil(seconds));
  return total >= 3600 ? FormatText("%ld:%02ld:%02ld", total / 3600, total / 60 % 60, total % 60)
                       : FormatText("%ld:%02ld", total / 60, total % 60);
}

}  // namespace

std::string ProgressLine(int done,
                         std::optional<int> total,
                         double elapsed,
                         const std::string& unit) {
  const double rate = elapsed > 0.0 ? done / elapsed : 0.0;
  if (!total || *total <= 0) {
    return FormatText("%d %s  %.1f %s/s", done, unit.c_str(), rate, unit.c_str());
  }
  const double share = std::min(1.0, static_cast<double>(done) / *total);
  const int filled = static_cast<int>(share * kBarWidth);
  std::string bar(static_cast<std::size_t>(filled), '=');
  if (filled < kBarWidth) bar += '>';
  bar.resize(kBarWidth, ' ');
  const double left = std::max(0, *total - done);
  const std::string eta = rate > 0.0 ? ClockText(left / rate) : "-:--";
  return FormatText("[%s] %d/%d %s  %.1f %s/s  ETA %s",
                    bar.c_str(),
                    done,
                    *total,
                    unit.c_str(),
                    rate,
                    unit.c_str(),
                    eta.c_str());
}

Progress::Mode Progress::ModeFor(std::FILE* stream) {
  return isatty(fileno(stream)) != 0 ? Mode::kBar : Mode::kLines;
}

void Progress::Update(int done) {
  done_ = done;
  if (mode_ == Mode::kQuiet) return;
  const double elapsed = stopwatch_.Milliseconds() / 1000.0;
  if (elapsed - last_draw_ < (mode_ == Mode::kBar ? kBarInterval : kLineInterval)) return;
  Draw(elapsed);
}

void Progress::Draw(double elapsed) {
  last_draw_ = elapsed;
  std::string line = ProgressLine(done_, total_, elapsed, unit_);
  if (mode_ == Mode::kLines) {
    std::fprintf(stream_, "%s\n", line.c_str());
  } else {
    const std::size_t length = line.size();
    line.resize(std::max(length, bar_length_), ' ');  // covers what is left of a longer line
    bar_length_ = length;
    std::fprintf(stream_, "\r%s", line.c_str());
  }
  std::fflush(stream_);
}

void Progress::Message(const std::string& text) {
  if (mode_ == Mode::kQuiet) return;
  if (bar_length_ > 0) {
    std::fprintf(stream_, "\r%*s\r", static_cast<int>(bar_length_), "");
    bar_length_ = 0;
  }
  std::fprintf(stream_, "%s\n", text.c_str());
  std::fflush(stream_);
}

void Progress::Finish() {
  if (mode_ == Mode::kQuiet) return;
  Draw(stopwatch_.Milliseconds() / 1000.0);
  if (mode_ == Mode::kBar) std::fprintf(stream_, "\n");
  bar_length_ = 0;
}

}  // namespace radive
