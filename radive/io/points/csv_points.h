// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radive/io/points/point_table.h"

namespace radive {

// Takes a table of points in text apart: a line with the names of the columns, then a line per
// point, see csv_text.h. All fields are float64. A cell that stands for no value is NaN; other
// words in a column with numbers are NaN too, with a remark. Lines with another number of cells are
// left out, with a remark.
//
// False, with the line and the expectation in `error`, when there is no line of names, no line that
// fits them, nothing but words in a column that has a role (see field_matching.h), and for tables
// of poses or of motion.
bool ParseCsvPoints(std::string_view bytes,
                    PointTable* table,
                    std::vector<std::string>* remarks,
                    std::string* error);

}  // namespace radive
