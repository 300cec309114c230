// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/csv_points.h"

#include <limits>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/points/csv_text.h"
#include "radive/io/points/field_matching.h"

namespace radive {
namespace {

// Words in the columns that hold numbers.
struct ColumnWords {
  std::size_t num_words = 0;
  std::size_t num_numbers = 0;
  int line = 0;  // of the first word
  std::string first;
};

std::string Place(int line) { return "line " + std::to_string(line); }

// What is to be said of columns with words. A column of nothing but words is a label, unless its
// name says that it is used. False, with the reason in `error`, when that leaves nothing to read.
bool JudgeWords(const PointTable& table,
                const std::vector<ColumnWords>& columns,
                std::vector<std::string>* remarks,
                std::string* error) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ColumnWords& words = columns[i];
    if (words.num_words == 0) continue;
    const std::string what = Place(words.line) + ": expected a number in the column " +
                             Quoted(table.fields[i].name) + ", found " + Quoted(words.first);
    const std::optional<FieldRole> role = RoleOfName(table.fields[i].name);
    if (words.num_numbers == 0) {
      if (!role || *role == FieldRole::kTime) continue;
      *error = what;
      return false;
    }
    remarks->push_back(what + "; " + std::to_string(words.num_words) +
                       " such cells are taken as missing");
  }
  return true;
}

}  // namespace

bool ParseCsvPoints(std::string_view bytes,
                    PointTable* table,
                    std::vector<std::string>* remarks,
                    std::string* error) {
  *table = PointTable();
  TextLines lines(bytes);
  const std::optional<CsvHead> head = ReadCsvHead(&lines, error);
  if (!head) return false;
  for (const std::string_view name : head->names) {
    table->AddField(std::string(name), NumericType::kFloat64);
  }
  if (HoldsPoses(table->fields)) {
    *error = "the columns are those of poses or of motion, expected points";
    return false;
  }
  std::vector<ColumnWords> words(table->fields.size());
  std::size_t num_left_out = 0;
  std::string left_out;  // the first of them
  std::string record;
  std::vector<std::string_view> cells;
  std::string_view line = head->first_line;
  do {
    if (IsCsvComment(line)) continue;
    SplitCells(line, head->delimiter, &cells);
    if (cells.size() != table->fields.size()) {
      if (num_left_out++ == 0) {
        left_out = Place(lines.number()) + ": expected " + std::to_string(table->fields.size()) +
                   " cells, found " + std::to_string(cells.size()) + ": " + Quoted(line);
      }
      continue;
    }
    record.clear();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::optional<double> value = ParseCell(cells[i]);
      words[i].num_numbers += value ? 1 : 0;
      if (!value && !IsMissing(cells[i]) && words[i].num_words++ == 0) {
        words[i].line = lines.number();
        words[i].first = cells[i];
      }
      AppendLittleEndian(value.value_or(std::numeric_limits<double>::quiet_NaN()), &record);
    }
    table->owned.insert(table->owned.end(), record.begin(), record.end());
    ++table->num_points;
  } while (lines.Next(&line));
  if (num_left_out > 0 && table->num_points == 0) {
    *error = left_out;
    if (head->delimiter == ',') {
      *error += "; decimal commas are only read where semicolons or tabs separate the cells";
    }
    return false;
  }
  if (num_left_out > 0) {
    remarks->push_back(std::to_string(num_left_out) + " lines do not have " +
                       std::to_string(table->fields.size()) +
                       " cells and are left out; the first: " + left_out);
  }
  table->data = table->owned.data();
  return JudgeWords(*table, words, remarks, error);
}

}  // namespace radive
