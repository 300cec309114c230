// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/durable_files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <vector>

#include "radive/util/system_message.h"

namespace radive {
namespace {

namespace fs = std::filesystem;

// From here on, one sync of the whole file system is faster than one for each file.
constexpr std::size_t kManyFiles = 64;

bool Sync(const fs::path& path, int (*sync)(int), std::string* error) {
  const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool is_synced = fd >= 0 && (sync(fd) == 0 || errno == EINVAL || errno == ENOTSUP);
  if (!is_synced) *error = path.string() + ": cannot be written: " + SystemMessage(errno);
  if (fd >= 0) close(fd);
  return is_synced;
}

}  // namespace

bool SyncPath(const fs::path& path, std::string* error) { return Sync(path, fsync, error); }

bool SyncTree(const fs::path& folder, std::string* error) {
  std::vector<fs::path> paths = {folder};
  std::error_code code;
  fs::recursive_directory_iterator entry(folder, code);
  for (; !code && entry != fs::recursive_directory_iterator(); entry.increment(code)) {
    const fs::file_type type = entry->symlink_status(code).type();
    if (type == fs::file_type::regular || type == fs::file_type::directory) {
      paths.push_back(entry->path());
    }
  }
  if (code) {
    *error = folder.string() + ": cannot be listed: " + SystemMessage(code);
    return false;
  }
  if (paths.size() > kManyFiles) return Sync(folder, syncfs, error);
  // The names in a folder last: the files behind them are on the disk by then.
  for (auto path = paths.rbegin(); path != paths.rend(); ++path) {
    if (!SyncPath(*path, error)) return false;
  }
  return true;
}

bool ExchangeFolders(const fs::path& a, const fs::path& b) {
  return renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
}

bool ReplaceFolder(const fs::path& made, const fs::path& folder, std::string* error) {
  if (!SyncTree(made, error)) return false;
  std::error_code code;
  if (!fs::exists(folder, code)) {
    fs::rename(made, folder, code);
  } else if (!ExchangeFolders(made, folder)) {
    // Without an exchange there is a moment without either.
    fs::remove_all(folder, code);
    if (!code) fs::rename(made, folder, code);
  }
  if (code) {
    *error = folder.string() + ": cannot be made: " + SystemMessage(code);
    return false;
  }
  if (!SyncPath(folder.parent_path(), error)) return false;
  fs::remove_all(made, code);
  return true;
}

}  // namespace radive
