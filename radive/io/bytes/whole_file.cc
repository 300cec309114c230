// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/whole_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace radive {

namespace fs = std::filesystem;

bool WriteWholeFile(const fs::path& path, std::string_view bytes, std::string* error) {
  const fs::path temporary = path.string() + ".tmp";
  std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) {
    *error = temporary.string() + ": cannot be written: " + std::generic_category().message(errno);
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return false;
  }
  std::error_code failure;
  fs::rename(temporary, path, failure);
  if (failure) *error = path.string() + ": cannot be written: " + failure.message();
  return !failure;
}

}  // namespace radive
