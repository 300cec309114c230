// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radive/io/points/point_table.h"

namespace radive {

// Takes a table of points in text apart: a line with the names of the columns, then a line a point,
// cells separated by commas, semicolons, tabs or blanks (the first of these in the line of names).
// Lines that start with # are left out, but the last one before the numbers may be the names. All
// fields are float64; a cell that is no number is NaN. Lines with another number of cells are left
// out, with a remark.
//
// False, with the line and the expectation in `error`, when there is no line of names.
bool ParseCsvPoints(std::string_view bytes,
                    PointTable* table,
                    std::vector<std::string>* remarks,
                    std::string* error);

}  // namespace radive
