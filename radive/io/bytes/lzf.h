// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace radive {

// Unpacks an LZF stream (as in compressed PCD files) of exactly `size` bytes. False, with the
// expectation in `error`, when the stream does not give that size; nothing is allocated that the
// stream cannot give.
bool UnpackLzf(std::string_view packed,
               std::size_t size,
               std::vector<char>* unpacked,
               std::string* error);

// Packs `bytes`. UnpackLzf() gives them back.
std::string PackLzf(std::string_view bytes);

}  // namespace radive
