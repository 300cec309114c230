// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace radive {

std::optional<FileLock> FileLock::Take(const std::filesystem::path& file,
                                       Wait wait,
                                       std::string* error) {
  error->clear();
  // Open for writing: NFS grants exclusive locks on such files only.
  const int fd = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  int status = fd < 0 ? -1 : 0;
  if (fd >= 0) {
    do {
      status = flock(fd, wait == Wait::kYes ? LOCK_EX : LOCK_EX | LOCK_NB);
    } while (status != 0 && errno == EINTR);
  }
  if (status == 0) return FileLock(fd);
  if (fd < 0 || errno != EWOULDBLOCK) {
    *error = file.string() + ": cannot be locked: " + std::strerror(errno);
  }
  if (fd >= 0) close(fd);
  return std::nullopt;
}

FileLock::FileLock(FileLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

FileLock::~FileLock() {
  if (fd_ >= 0) close(fd_);
}

}  // namespace radive
