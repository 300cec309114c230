// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace radive {

// True when `a` comes before `b` with runs of digits compared as numbers: "2" < "10", "s9" < "s10",
// "007" < "8". A strict total order: names that differ only in leading zeros are ordered as plain
// text. The runs may have any length.
bool NaturalLess(std::string_view a, std::string_view b);

}  // namespace radive
