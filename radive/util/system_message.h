// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <system_error>

namespace radive {

// What the system says of an error number (errno).
inline std::string SystemMessage(int number) { return std::generic_category().message(number); }

}  // namespace radive
