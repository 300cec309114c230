// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace radive {

// First and last bytes of an MCAP file.
inline constexpr std::string_view kMcapMagic("\x89MCAP0\r\n", 8);

}  // namespace radive
