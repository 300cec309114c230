// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radive/io/bytes/text_lines.h"

namespace radive {

// What is in front of the numbers of a text table.
struct CsvHead {
  std::vector<std::string_view> names;  // of the columns, one for each cell of a line of numbers
  char delimiter = ',';                 // of the lines of numbers
  std::string_view first_line;          // with numbers; empty: there is none
};

// Splits a line into cells, without blanks around them and without quotes; a delimiter in quotes is
// part of its cell. The delimiter ' ' stands for any number of blanks.
void SplitCells(std::string_view line, char delimiter, std::vector<std::string_view>* cells);

// True for lines that say nothing: empty ones, and those that start with #, % or //.
bool IsCsvComment(std::string_view line);

// The number in a cell, with a decimal point or a decimal comma: 1,25 is 1.25 where the comma is
// not what separates the cells. Nothing for other words.
std::optional<double> ParseCell(std::string_view cell);

// True for a cell that stands for no value: empty, -, NA, N/A, null, none, nan.
bool IsMissing(std::string_view cell);

// Reads up to the first line of numbers. The names are in the first line that is no comment, or,
// where that holds numbers, in the last comment; semicolons, tabs, commas, bars and blanks separate
// cells, whichever comes first in this order, or what a line "sep=;" in front says. A column
// without a name in front of the others (as R and pandas write the number of the row) gets the
// name "". Nothing, with the line in `error`, when there are no names.
std::optional<CsvHead> ReadCsvHead(TextLines* lines, std::string* error);

}  // namespace radive
