// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string_view>

#include "radive/io/bytes/random_access_file.h"

namespace radive {

// CRC-32 (IEEE 802.3) of the bytes, as MCAP has it; `before`: that of the bytes in front of them.
std::uint32_t Crc32(std::string_view bytes, std::uint32_t before = 0);

// The same of all bytes of a file or a part of one, read in pieces; nothing when it cannot be read.
std::optional<std::uint32_t> Crc32(RandomAccessFile* file);

}  // namespace radive
