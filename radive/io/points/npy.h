// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radive/io/points/point_table.h"

namespace radive {

// Takes a NumPy array file (versions 1 to 3) apart: two dimensions, a point a row, float32 or
// float64 of either byte order, in C or Fortran order. Arrays have no names: `columns` names those
// that count ("_" for others); it must have as many entries as the array has columns, or be empty:
// then 3 columns are x y z, 4 are x y z power and 5 are x y z power doppler, as in K-Radar. The
// table refers to `bytes` for arrays in C order.
//
// False, with what was found and expected in `error`, for anything else.
bool ParseNpy(std::string_view bytes,
              const std::vector<std::string>& columns,
              PointTable* table,
              std::vector<std::string>* remarks,
              std::string* error);

}  // namespace radive
