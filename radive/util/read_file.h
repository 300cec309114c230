// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace radive {

// Reads all bytes of a file, or of a pipe or a device, whose end may never come: no more than
// `max_bytes` [bytes], and no waiting beyond ten seconds for the next ones. False, with the reason
// without the path in `reason` and no bytes, for a folder and for what cannot be read, is larger,
// or is silent.
bool ReadFileBytes(const std::filesystem::path& path,
                   std::uintmax_t max_bytes,
                   std::string* bytes,
                   std::string* reason);

}  // namespace radive
