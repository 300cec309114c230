// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "radive/util/system_message.h"

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
    *error = file.string() + ": cannot be locked: " + SystemMessage(errno);
  }
  if (fd >= 0) close(fd);
  return std::nullopt;
}

std::optional<FileLock> FileLock::TakeFolder(const std::filesystem::path& folder,
                                             std::string* error) {
  error->clear();
  for (;;) {
    const int fd = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) {
      *error = folder.string() + ": cannot be locked: " + SystemMessage(errno);
      return std::nullopt;
    }
    if (flock(fd, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      close(fd);
      return std::nullopt;
    }
    // Another may have put a new folder in its place between the two calls, see OutputFolder.
    struct stat locked = {}, named = {};
    if (fstat(fd, &locked) == 0 && stat(folder.c_str(), &named) == 0 &&
        locked.st_dev == named.st_dev && locked.st_ino == named.st_ino) {
      return FileLock(fd);
    }
    close(fd);
  }
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
