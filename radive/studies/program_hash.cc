// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/studies/program_hash.h"

#include <link.h>

#include "radive/util/content_hash.h"

namespace radive {
namespace {

// Path of the shared library of that name in this process; empty when it is linked statically.
std::string LoadedLibrary() {
  std::string path;
  const auto look = [](dl_phdr_info* info, std::size_t, void* found) {
    const std::string name = info->dlpi_name;
    const std::string file = name.substr(name.find_last_of('/') + 1);
    if (file.rfind("libradive.so", 0) == 0) *static_cast<std::string*>(found) = name;
    return 0;
  };
  dl_iterate_phdr(look, &path);
  return path;
}

}  // namespace

std::optional<std::string> ProgramHash(const std::filesystem::path& program, std::string* error) {
  const auto hash = HashFile(program, error);
  const std::string library = LoadedLibrary();
  if (!hash || library.empty()) return hash;
  const auto library_hash = HashFile(library, error);
  if (!library_hash) return std::nullopt;
  return HashText(*hash + *library_hash);
}

}  // namespace radive
