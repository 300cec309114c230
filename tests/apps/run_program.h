// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/scratch_folder.h"

namespace radive::testing {

struct Outcome {
  int code = -1;       // exit status, or minus the signal
  std::string output;  // both streams
};

// Starts `program`; both of its streams go to `log`.
inline pid_t StartProgram(const std::string& program,
                          const std::vector<std::string>& arguments,
                          const std::filesystem::path& log) {
  const pid_t child = fork();
  if (child != 0) return child;
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  std::vector<char*> argv;
  argv.push_back(const_cast<char*>(program.data()));
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.data()));
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  _exit(127);
}

inline Outcome WaitForProgram(pid_t child, const std::filesystem::path& log) {
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), ReadFile(log)};
}

inline Outcome RunProgram(const std::string& program, const std::vector<std::string>& arguments) {
  const ScratchFolder scratch;
  const std::filesystem::path log = scratch.path() / "log";
  return WaitForProgram(StartProgram(program, arguments, log), log);
}

}  // namespace radive::testing
