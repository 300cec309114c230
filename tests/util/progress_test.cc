// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/progress.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace radive {
namespace {

TEST(ProgressLine, ShowsBarRateAndTimeLeft) {
  // A third of 300 scans in 10 s: 10 scans/s, 200 left, 20 s to go.
  EXPECT_EQ(ProgressLine(100, 300, 10.0),
            "[==========>                   ] 100/300 scans  10.0 scans/s  ETA 0:20");
  EXPECT_EQ(ProgressLine(300, 300, 30.0),
            "[==============================] 300/300 scans  10.0 scans/s  ETA 0:00");
  EXPECT_EQ(ProgressLine(15, 30, 10.0, "runs"),
            "[===============>              ] 15/30 runs  1.5 runs/s  ETA 0:10");
  EXPECT_EQ(ProgressLine(0, 300, 0.0),
            "[>                             ] 0/300 scans  0.0 scans/s  ETA -:--");
}

TEST(ProgressLine, ShowsHoursAndUnknownTotals) {
  EXPECT_EQ(ProgressLine(1, 3726, 1.0).substr(47), "1.0 scans/s  ETA 1:02:05");
  EXPECT_EQ(ProgressLine(50, std::nullopt, 2.0), "50 scans  25.0 scans/s");
}

std::string Shown(Progress::Mode mode) {
  std::FILE* file = std::tmpfile();
  Progress progress(file, mode, 2);
  progress.Message("hello");
  progress.Update(1);
  progress.Finish();
  std::rewind(file);
  char text[400] = {};
  const std::size_t size = std::fread(text, 1, sizeof(text) - 1, file);
  std::fclose(file);
  return {text, size};
}

TEST(Progress, QuietShowsNothing) { EXPECT_EQ(Shown(Progress::Mode::kQuiet), ""); }

TEST(Progress, LinesHaveNoControlCharacters) {
  const std::string text = Shown(Progress::Mode::kLines);
  EXPECT_EQ(text.substr(0, 6), "hello\n");
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_NE(text.find("] 1/2 scans"), std::string::npos);
  EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, BarRedrawsItself) {
  const std::string text = Shown(Progress::Mode::kBar);
  EXPECT_NE(text.find("\r["), std::string::npos);
  EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, AFileIsNoTerminal) {
  std::FILE* file = std::tmpfile();
  EXPECT_EQ(Progress::ModeFor(file), Progress::Mode::kLines);
  std::fclose(file);
}

}  // namespace
}  // namespace radive
