// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace radive {

// Writes `bytes` to a temporary name beside `path` and renames, so that the file appears whole or
// not at all. False, with the file and the reason in `error`, when that fails.
bool WriteWholeFile(const std::filesystem::path& path, std::string_view bytes, std::string* error);

}  // namespace radive
