// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/yaml_points.h"

#include <limits>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/bytes/number_text.h"
#include "radive/io/bytes/text_lines.h"

namespace radive {
namespace {

constexpr std::size_t kMostKeys = 1000;

struct Entry {
  std::size_t indent = 0;  // of the key
  bool begins_item = false;
  std::string_view key, value;
};

// "    - key: value" or "      key: value"; false for a line of another kind.
bool ParseEntry(std::string_view line, Entry* entry) {
  entry->indent = line.find_first_not_of(' ');
  if (entry->indent == std::string_view::npos) return false;
  line.remove_prefix(entry->indent);
  entry->begins_item = line.substr(0, 2) == "- ";
  if (entry->begins_item) {
    const std::size_t begin = line.find_first_not_of(' ', 1);
    if (begin == std::string_view::npos) return false;
    entry->indent += begin;
    line.remove_prefix(begin);
  }
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos || colon == 0) return false;
  entry->key = TrimBlanks(line.substr(0, colon));
  entry->value = TrimBlanks(line.substr(colon + 1));
  return true;
}

double ValueOf(std::string_view text) {
  if (text == "true") return 1.0;
  if (text == "false") return 0.0;
  return ParseDouble(text).value_or(std::numeric_limits<double>::quiet_NaN());
}

// Collects the points; the keys of the first one are the fields.
class PointList {
 public:
  explicit PointList(PointTable* table) : table_(table) {}

  void BeginPoint() {
    EndPoint();
    is_open_ = true;
  }

  void Add(std::string_view key, std::string_view value) {
    if (table_->num_points == 0) {
      if (table_->fields.size() == kMostKeys) return;
      table_->AddField(std::string(key), NumericType::kFloat64);
      point_.push_back(ValueOf(value));
      return;
    }
    for (std::size_t i = 0; i < point_.size(); ++i) {
      // Most points have their keys in the order of the first one.
      const std::size_t k = (next_ + i) % point_.size();
      if (table_->fields[k].name != key) continue;
      point_[k] = ValueOf(value);
      next_ = k + 1;
      return;
    }
  }

  void EndPoint() {
    if (!is_open_) return;
    is_open_ = false;
    std::string record;
    for (const double value : point_) AppendLittleEndian(value, &record);
    table_->owned.insert(table_->owned.end(), record.begin(), record.end());
    ++table_->num_points;
    point_.assign(point_.size(), std::numeric_limits<double>::quiet_NaN());
    next_ = 0;
  }

 private:
  PointTable* const table_;
  std::vector<double> point_;
  std::size_t next_ = 0;
  bool is_open_ = false;
};

}  // namespace

bool ParseYamlPoints(std::string_view text,
                     PointTable* table,
                     std::vector<std::string>* remarks,
                     std::string* error) {
  *table = PointTable();
  PointList points(table);
  TextLines lines(text);
  std::size_t indent = 0;
  bool is_in_list = false;
  for (std::string_view line; lines.Next(&line);) {
    Entry entry;
    if (!ParseEntry(line, &entry)) continue;
    if (!is_in_list) {
      if (!entry.begins_item) continue;
      is_in_list = true;
      indent = entry.indent;
    }
    if (entry.indent < indent) {
      remarks->push_back("line " + std::to_string(lines.number()) +
                         ": what follows the list of points is left out");
      break;
    }
    if (entry.indent > indent) continue;  // nested, no number of the point
    if (entry.begins_item) points.BeginPoint();
    points.Add(entry.key, entry.value);
  }
  points.EndPoint();
  table->data = table->owned.data();
  if (is_in_list) return true;
  *error = "expected a list of points ('- range: ...') in the YAML text, found none";
  return false;
}

}  // namespace radive
