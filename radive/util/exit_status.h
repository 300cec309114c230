// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// Exit status of all programs; README.md has the table. A script may take 0 alone for a result.
enum class ExitStatus {
  kSuccess = 0,

  // Nothing was done, or what was done is not whole: a flag or setting is wrong, the input cannot
  // be read, a file or the standard output cannot be written.
  kFailure = 1,

  // Ran to the end and wrote its files, but they hold no result: no scan was registered or found
  // standing (radive_odometry), a run of the study is not ok (radive_batch).
  kNoResult = 2,

  // By SIGINT or SIGTERM (128 + SIGINT, as shells have it); what was written is whole.
  kInterrupted = 130
};

// What main() returns.
constexpr int Code(ExitStatus status) { return static_cast<int>(status); }

}  // namespace radive
