// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/child_process.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include "radive/util/system_message.h"

namespace radive {
namespace {

constexpr off_t kMaxOutput = 1 << 20;

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void WriteText(const std::string& text) {
  const ssize_t ignored = write(STDERR_FILENO, text.data(), text.size());
  static_cast<void>(ignored);
}

}  // namespace

void ChildProcess::PrepareChild(pid_t parent, int inherited_fd) const {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // the parent died before it could be noticed
  const int null = open("/dev/null", O_RDONLY);
  dup2(null, STDIN_FILENO);
  dup2(output_fd_, STDOUT_FILENO);
  dup2(output_fd_, STDERR_FILENO);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE}) std::signal(number, SIG_DFL);
  // Everything else of the parent's is closed, above all the locks that it holds for other
  // children.
  const auto last = ~0u;
  if (inherited_fd < 0) {
    close_range(3, last, 0);
  } else {
    fcntl(inherited_fd, F_SETFD, 0);
    if (inherited_fd > 3) close_range(3, static_cast<unsigned>(inherited_fd) - 1, 0);
    close_range(static_cast<unsigned>(inherited_fd) + 1, last, 0);
  }
}

std::unique_ptr<ChildProcess> ChildProcess::Start(const std::vector<std::string>& command,
                                                  int inherited_fd,
                                                  std::string* error) {
  std::vector<std::string> words = command;
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return Start(
      [&](std::string* reason) {
        execv(arguments[0], arguments.data());
        *reason = std::string(arguments[0]) + ": cannot be executed: " + SystemMessage(errno);
        WriteText(*reason + "\n");
        _exit(127);
        return false;
      },
      inherited_fd,
      error);
}

std::unique_ptr<ChildProcess> ChildProcess::Start(
    const std::function<bool(std::string* error)>& work, int inherited_fd, std::string* error) {
  std::unique_ptr<ChildProcess> child(new ChildProcess);
  child->output_fd_ = memfd_create("output", MFD_CLOEXEC);
  const pid_t parent = getpid();
  std::fflush(nullptr);  // or the child would write what is buffered once more
  if (child->output_fd_ >= 0) child->pid_ = fork();
  if (child->pid_ == 0) {
    child->PrepareChild(parent, inherited_fd);
    std::string reason;
    const bool ok = work(&reason);
    if (!ok) WriteText(reason + "\n");
    _exit(ok ? 0 : 1);
  }
  if (child->pid_ > 0) {
    setpgid(child->pid_,
            child->pid_);  // here as well, lest Kill() come before the child's own call
    return child;
  }
  *error = "cannot start a process: " + SystemMessage(errno);
  return nullptr;
}

ChildProcess::~ChildProcess() {
  if (pid_ > 0 && !has_ended_) {
    Kill();
    waitpid(pid_, nullptr, 0);
  }
  if (output_fd_ >= 0) close(output_fd_);
}

bool ChildProcess::HasEnded() {
  if (has_ended_) return true;
  int status = 0;
  rusage usage{};
  if (wait4(pid_, &status, WNOHANG, &usage) != pid_) return false;
  has_ended_ = true;
  seconds_ = stopwatch_.Milliseconds() / 1000.0;
  exit_status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  signal_ = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  cpu_seconds_ = radive::Seconds(usage.ru_utime) + radive::Seconds(usage.ru_stime);
  peak_memory_mb_ = static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
  return true;
}

void ChildProcess::Kill() const {
  if (pid_ <= 0 || has_ended_) return;
  kill(-pid_, SIGKILL);  // and what it has started
  kill(pid_, SIGKILL);
}

double ChildProcess::Seconds() const {
  return has_ended_ ? seconds_ : stopwatch_.Milliseconds() / 1000.0;
}

std::string ChildProcess::Output() const {
  const off_t size = lseek(output_fd_, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, kMaxOutput)), '\0');
  const ssize_t count =
      pread(output_fd_, text.data(), text.size(), std::max<off_t>(0, size - kMaxOutput));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  return text;
}

}  // namespace radive
