// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace radive {

// The layout of raw records that the numbers in a file prove, see RecordProof: a stored range that
// is |x y z|, or scan indices 0, -1, ... in a column. Empty when they prove none of those that the
// datasets have. `evidence` says what was seen.
std::string ProvenLayout(std::string_view bytes, std::string* evidence);

}  // namespace radive
