// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace radive {

// A lock that one process at a time can hold, on a file that is made when it is missing and stays
// behind. It ends with the object, or with the process, however that ends. Processes that inherit
// fd() hold it as well (flock(2)). Works across machines where the file system does.
class FileLock {
 public:
  enum class Wait { kNo, kYes };

  // Nothing when another holds the lock (then `error` is empty), or when the file cannot be made
  // or locked.
  static std::optional<FileLock> Take(const std::filesystem::path& file,
                                      Wait wait,
                                      std::string* error);

  // The same on a folder that exists, without a file in it. File systems that lock files only (NFS)
  // grant it to everyone.
  static std::optional<FileLock> TakeFolder(const std::filesystem::path& folder,
                                            std::string* error);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

  int fd() const { return fd_; }

 private:
  explicit FileLock(int fd) : fd_(fd) {}

  int fd_ = -1;
};

}  // namespace radive
