// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/csv_text.h"

#include <algorithm>
#include <cmath>

#include "radive/io/bytes/number_text.h"
#include "radive/io/points/point_table.h"

namespace radive {
namespace {

char DelimiterOf(std::string_view line) {
  for (const char delimiter : {';', '\t', ',', '|'}) {
    if (line.find(delimiter) != std::string_view::npos) return delimiter;
  }
  return ' ';
}

bool IsBlankOrQuote(char c) { return c == ' ' || c == '\t' || c == '"'; }

std::string_view WithoutQuotes(std::string_view cell) {
  // Most cells are numbers and nothing else.
  if (!cell.empty() && !IsBlankOrQuote(cell.front()) && !IsBlankOrQuote(cell.back())) return cell;
  cell = TrimBlanks(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
    cell = TrimBlanks(cell.substr(1, cell.size() - 2));
  }
  return cell;
}

// Where the cell at the front of `line` ends.
std::size_t EndOfCell(std::string_view line, char delimiter) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin != std::string_view::npos && line[begin] == '"' && delimiter != '"') {
    const std::size_t quote = line.find('"', begin + 1);
    if (quote != std::string_view::npos) return line.find(delimiter, quote + 1);
  }
  return line.find(delimiter);
}

bool IsNumbers(const std::vector<std::string_view>& cells) {
  return std::all_of(cells.begin(),
                     cells.end(),
                     [](std::string_view cell) { return ParseCell(cell) || IsMissing(cell); }) &&
         std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
           return ParseCell(cell).has_value();
         });
}

// True for cells with numbers and words (a label) that are as many as the names in a comment.
bool IsRecordOf(std::string_view comment, const std::vector<std::string_view>& cells) {
  std::vector<std::string_view> names;
  SplitCells(comment, DelimiterOf(comment), &names);
  return names.size() == cells.size() &&
         std::any_of(cells.begin(), cells.end(), [](std::string_view cell) {
           return ParseCell(cell).has_value();
         });
}

std::string_view WithoutCommentSign(std::string_view line) {
  return TrimBlanks(line.substr(line.front() == '/' ? 2 : 1));
}

// Brings the number of names to that of the cells of the first line of numbers: tables of R have no
// name for the number of the row, and some writers end each line with a delimiter.
void FitNames(std::size_t num_cells, CsvHead* head) {
  if (head->names.size() == num_cells + 1 && head->names.back().empty()) head->names.pop_back();
  if (head->names.size() + 1 != num_cells) return;
  std::vector<std::string_view> cells;
  SplitCells(head->first_line, head->delimiter, &cells);
  if (cells.back().empty()) {
    head->names.emplace_back();
  } else if (cells.front() == "0" || cells.front() == "1") {
    head->names.insert(head->names.begin(), std::string_view());
  }
}

}  // namespace

void SplitCells(std::string_view line, char delimiter, std::vector<std::string_view>* cells) {
  cells->clear();
  if (delimiter == ' ') {
    for (std::string_view word = TakeWord(&line); !word.empty(); word = TakeWord(&line)) {
      if (cells->size() == kMostColumns) return;
      cells->push_back(WithoutQuotes(word));
    }
    return;
  }
  const bool has_quotes = line.find('"') != std::string_view::npos;
  while (cells->size() < kMostColumns) {
    const std::size_t end = has_quotes ? EndOfCell(line, delimiter) : line.find(delimiter);
    cells->push_back(WithoutQuotes(line.substr(0, end)));
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
  }
}

bool IsCsvComment(std::string_view line) {
  if (!line.empty() && line.front() >= '0' && line.front() <= '9') return false;
  line = TrimBlanks(line);
  return line.empty() || line.front() == '#' || line.front() == '%' || line.substr(0, 2) == "//";
}

std::optional<double> ParseCell(std::string_view cell) {
  const std::optional<double> number = ParseDouble(cell);
  if (number || cell.size() > 60) return number;
  const std::size_t comma = cell.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  std::string with_point(cell);
  with_point[comma] = '.';
  return cell.find('.') == std::string_view::npos ? ParseDouble(with_point) : std::nullopt;
}

bool IsMissing(std::string_view cell) {
  if (cell.size() > 4) return false;
  const std::string word = LowerCase(cell);
  return word.empty() || word == "-" || word == "na" || word == "n/a" || word == "null" ||
         word == "none" || word == "nan";
}

std::optional<CsvHead> ReadCsvHead(TextLines* lines, std::string* error) {
  CsvHead head;
  std::string_view names, comment;
  std::vector<std::string_view> cells;
  char said = '\0';  // the delimiter that the file says
  const auto delimiter_of = [&](std::string_view line) {
    return said == '\0' ? DelimiterOf(line) : said;
  };
  for (std::string_view line; lines->Next(&line);) {
    line = TrimBlanks(line);
    if (line.size() == 5 && LowerCase(line.substr(0, 4)) == "sep=") {
      said = line[4];
      continue;
    }
    if (IsCsvComment(line)) {
      if (!line.empty() && names.empty()) comment = WithoutCommentSign(line);
      continue;
    }
    SplitCells(line, delimiter_of(line), &cells);
    if (names.empty() && !IsNumbers(cells) && !IsRecordOf(comment, cells)) {
      names = line;
      continue;
    }
    if (names.empty()) names = comment;
    head.first_line = line;
    head.delimiter = delimiter_of(line);
    break;
  }
  if (names.empty()) names = comment;
  if (names.empty()) {
    *error = "line " + std::to_string(lines->number()) +
             ": expected the names of the columns (x,y,z,doppler,...) before the numbers";
    return std::nullopt;
  }
  // A commented line of names may be separated by commas where the numbers are by blanks.
  SplitCells(names, delimiter_of(names), &head.names);
  if (!head.first_line.empty()) {
    SplitCells(head.first_line, head.delimiter, &cells);
    FitNames(cells.size(), &head);
  }
  return head;
}

}  // namespace radive
