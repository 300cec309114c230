// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/csv_points.h"

#include <limits>

#include "radive/io/bytes/number_text.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

char DelimiterOf(std::string_view names) {
  for (const char delimiter : {',', ';', '\t'}) {
    if (names.find(delimiter) != std::string_view::npos) return delimiter;
  }
  return ' ';
}

std::string_view WithoutQuotes(std::string_view cell) {
  cell = TrimBlanks(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
    cell = TrimBlanks(cell.substr(1, cell.size() - 2));
  }
  return cell;
}

void SplitCells(std::string_view line, char delimiter, std::vector<std::string_view>* cells) {
  cells->clear();
  if (delimiter == ' ') {
    for (std::string_view word = TakeWord(&line); !word.empty(); word = TakeWord(&line)) {
      if (cells->size() == kMostColumns) return;
      cells->push_back(WithoutQuotes(word));
    }
    return;
  }
  while (cells->size() < kMostColumns) {
    const std::size_t end = line.find(delimiter);
    cells->push_back(WithoutQuotes(line.substr(0, end)));
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
  }
}

bool IsNumbers(const std::vector<std::string_view>& cells) {
  for (const std::string_view cell : cells) {
    if (!ParseDouble(cell)) return false;
  }
  return true;
}

// The line of names: the first that is no comment, or, where that holds numbers, the last comment.
bool FindNames(TextLines* lines, std::string_view* names, std::string_view* first_numbers) {
  std::string_view comment;
  std::vector<std::string_view> cells;
  for (std::string_view line; lines->Next(&line);) {
    line = TrimBlanks(line);
    if (line.empty()) continue;
    if (line.front() == '#') {
      comment = TrimBlanks(line.substr(1));
      continue;
    }
    SplitCells(line, DelimiterOf(line), &cells);
    const bool is_numbers = IsNumbers(cells);
    *names = is_numbers ? comment : line;
    *first_numbers = is_numbers ? line : std::string_view();
    return !names->empty();
  }
  *names = comment;
  return !comment.empty();
}

}  // namespace

bool ParseCsvPoints(std::string_view bytes,
                    PointTable* table,
                    std::vector<std::string>* remarks,
                    std::string* error) {
  *table = PointTable();
  TextLines lines(bytes);
  std::string_view names, line;
  if (!FindNames(&lines, &names, &line)) {
    *error = "line " + std::to_string(lines.number()) +
             ": expected the names of the columns (x,y,z,doppler,...) before the numbers";
    return false;
  }
  // A commented line of names may be separated by commas where the numbers are by blanks.
  char delimiter = DelimiterOf(names);
  std::vector<std::string_view> cells;
  SplitCells(names, delimiter, &cells);
  for (const std::string_view name : cells) {
    table->AddField(std::string(name), NumericType::kFloat64);
  }
  if (!line.empty()) delimiter = DelimiterOf(line);
  std::size_t num_left_out = 0;
  std::string record;
  do {
    line = TrimBlanks(line);
    if (line.empty() || line.front() == '#') continue;
    SplitCells(line, delimiter, &cells);
    if (cells.size() != table->fields.size()) {
      ++num_left_out;
      continue;
    }
    record.clear();
    for (const std::string_view cell : cells) {
      AppendLittleEndian(ParseDouble(cell).value_or(std::numeric_limits<double>::quiet_NaN()),
                         &record);
    }
    table->owned.insert(table->owned.end(), record.begin(), record.end());
    ++table->num_points;
  } while (lines.Next(&line));
  if (num_left_out > 0) {
    remarks->push_back(std::to_string(num_left_out) + " lines do not have " +
                       std::to_string(table->fields.size()) + " cells and are left out");
  }
  table->data = table->owned.data();
  return true;
}

}  // namespace radive
