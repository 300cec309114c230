// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/whole_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "radive/util/durable_files.h"
#include "radive/util/system_message.h"

namespace radive {

namespace fs = std::filesystem;

bool WriteFile(const fs::path& path, std::string_view bytes, std::string* error) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) return true;
  *error = path.string() + ": cannot be written: " + SystemMessage(errno);
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) fs::remove(path, ignored);
  return false;
}

bool WriteWholeFile(const fs::path& path, std::string_view bytes, std::string* error) {
  const fs::path temporary = path.string() + ".tmp";
  return WriteFile(temporary, bytes, error) && RenameDurably(temporary, path, error);
}

bool RenameDurably(const fs::path& written, const fs::path& path, std::string* error) {
  bool is_done = SyncPath(written, error);
  if (is_done) {
    std::error_code failure;
    fs::rename(written, path, failure);
    if (failure) *error = path.string() + ": cannot be written: " + SystemMessage(failure);
    is_done = !failure;
  }
  if (!is_done) {
    std::error_code ignored;
    fs::remove(written, ignored);
    return false;
  }
  return SyncPath(path.has_parent_path() ? path.parent_path() : ".", error);
}

}  // namespace radive
