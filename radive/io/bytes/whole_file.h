// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace radive {

// Writes `bytes` into the file `path`, over what it held. For folders that are published as a
// whole, see OutputFolder. False, with the file and the reason in `error`, when that fails; nothing
// of the file is left then.
bool WriteFile(const std::filesystem::path& path, std::string_view bytes, std::string* error);

// The same in one step that outlasts a power cut: writes to a temporary name beside `path`, syncs
// and renames, so that the file appears whole or not at all.
bool WriteWholeFile(const std::filesystem::path& path, std::string_view bytes, std::string* error);

// Syncs the file `written` and gives it the name `path`, in the same folder; the second half of
// WriteWholeFile().
bool RenameDurably(const std::filesystem::path& written,
                   const std::filesystem::path& path,
                   std::string* error);

}  // namespace radive
