// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "radive/io/bags/message_source.h"
#include "radive/io/bags/open_bag_file.h"

namespace radive {

// Opens the bag at `path`. Null when that fails; `error` then says what was found where, and what
// was expected. Only the indexes are read, unless they are missing.
std::unique_ptr<MessageSource> OpenMessageSource(const std::filesystem::path& path,
                                                 BagFormat format,
                                                 const MessageLimits& limits,
                                                 std::string* error);

}  // namespace radive
