// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace radive {

// Unpacks an LZF stream (as in compressed PCD files) of exactly `size` bytes. A control byte c
//   c < 32   is followed by c + 1 bytes to be taken as they are;
//   c >= 32  repeats (c >> 5) + 2 bytes (with one byte more to add to the length when c >> 5 is 7)
//            from where ((c & 31) << 8 | next byte) + 1 bytes before.
// False, with the place in `error`, when the stream does not give that size; nothing is allocated
// that the stream cannot give.
bool UnpackLzf(std::string_view packed,
               std::size_t size,
               std::vector<char>* unpacked,
               std::string* error);

// Packs `bytes`, greedily. UnpackLzf() gives them back.
std::string PackLzf(std::string_view bytes);

}  // namespace radive
