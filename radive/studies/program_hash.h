// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace radive {

// Hash of a program of this project: of its file, and of libradive where that is a shared library
// (the one that this process uses, for they are built and installed together).
std::optional<std::string> ProgramHash(const std::filesystem::path& program, std::string* error);

}  // namespace radive
