// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sys/types.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "radive/util/stopwatch.h"

namespace radive {

// A process that works for this one and never outlives it: it is killed with the object, and by
// the system when this process dies. It has a process group of its own, so Ctrl-C reaches this
// process alone. What it writes on its standard streams is kept in memory.
class ChildProcess {
 public:
  // Starts `command`, a program with its arguments. `inherited_fd` stays open in it (a FileLock,
  // which the child then holds too); -1: none. Null, with the reason in `error`, when there is no
  // process to be had; a program that cannot be executed ends with exit status 127 and a message.
  static std::unique_ptr<ChildProcess> Start(const std::vector<std::string>& command,
                                             int inherited_fd,
                                             std::string* error);

  // The same for a function of this program. The exit status is 0 when it returns true, else 1, and
  // its error is the output. Call it while this process has one thread only.
  static std::unique_ptr<ChildProcess> Start(const std::function<bool(std::string* error)>& work,
                                             int inherited_fd,
                                             std::string* error);

  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  // True from the end of the process on; does not wait.
  bool HasEnded();

  // Kills it and the processes that it has started.
  void Kill() const;

  double Seconds() const;  // since the start, or from start to end [s]

  // After the end.
  int exit_status() const { return exit_status_; }  // -1 when a signal ended it
  int signal() const { return signal_; }            // 0 when it ended by itself
  double cpu_seconds() const { return cpu_seconds_; }
  double peak_memory_mb() const { return peak_memory_mb_; }  // [MB = 1e6 bytes]
  std::string Output() const;                                // both streams, the last MiB of them

 private:
  ChildProcess() = default;

  // In the child: gets it ready, and does not come back when that fails.
  void PrepareChild(pid_t parent, int inherited_fd) const;

  pid_t pid_ = -1;
  int output_fd_ = -1;
  bool has_ended_ = false;
  Stopwatch stopwatch_;
  double seconds_ = 0.0;
  int exit_status_ = -1;
  int signal_ = 0;
  double cpu_seconds_ = 0.0;
  double peak_memory_mb_ = 0.0;
};

}  // namespace radive
