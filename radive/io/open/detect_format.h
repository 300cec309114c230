// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include "radive/io/scans/input_options.h"

namespace radive {

// Finds out what form the drive at `path` has: bags by their first bytes, files by their extension,
// folders by what they hold, raw files by whether their columns make sense. Only for input.format:
// auto; sets the format, and layout and folder where they are empty and the dataset is known.
// `reason` says what was found and why it was taken so.
//
// False, with what was found and what was looked for in `error`, when nothing fits or several
// things do.
bool DetectFormat(const std::filesystem::path& path,
                  InputOptions* options,
                  std::string* reason,
                  std::string* error);

}  // namespace radive
