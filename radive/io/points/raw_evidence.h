// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace radive {

// The layout of raw records that the numbers in a file prove: a stored range that is |x y z|
// (hercules29, tj4d8, mscrad17), or scan indices 0, -1, ... in the last column (vod7). Empty when
// none does. `evidence` says what was seen.
std::string ProvenLayout(std::string_view bytes, std::string* evidence);

// Names of the known layouts whose records a file of this size [bytes] can hold in whole.
std::vector<std::string> LayoutsOfSize(std::size_t size);

}  // namespace radive
