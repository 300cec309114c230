// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radive/io/points/point_table.h"

namespace radive {

// Takes the `vertex` element of a PLY file (1.0) apart: ascii, binary_little_endian and
// binary_big_endian. Elements before it and list properties are passed over. The table refers to
// `bytes` where the vertices are binary and have no lists. A file that ends early gives the points
// before the break, with a remark.
//
// False, with the place and the expectation in `error`, when there is no such element or the header
// cannot be read.
bool ParsePly(std::string_view bytes,
              PointTable* table,
              std::vector<std::string>* remarks,
              std::string* error);

}  // namespace radive
