// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/points/csv_drive.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "radive/io/points/csv_text.h"
#include "radive/io/points/field_matching.h"

namespace radive {
namespace {

constexpr std::size_t kFewestLines = 3;  // of a scan, on average

bool NamesFrames(std::string_view name) {
  std::string lower_case = LowerCase(name);
  for (const char* end : {"_id", "_idx", "_index", "_number", "_num", "_nr", "id", "index"}) {
    const std::string_view ending(end);
    if (lower_case.size() > ending.size() &&
        std::string_view(lower_case).substr(lower_case.size() - ending.size()) == ending) {
      lower_case.resize(lower_case.size() - ending.size());
      break;
    }
  }
  return lower_case == "frame" || lower_case == "scan" || lower_case == "sweep";
}

bool NamesTimes(std::string_view name) {
  const std::string lower_case = LowerCase(name);
  return RoleOfName(name) == FieldRole::kTime && lower_case.find("offset") == std::string::npos;
}

// Groups the lines from `begin` on by their cell in `column`. `time_column`: head.names.size() for
// none.
std::vector<CsvScan> Group(std::string_view text,
                           std::size_t begin,
                           const CsvHead& head,
                           std::size_t column,
                           std::size_t time_column,
                           std::size_t* num_lines) {
  std::vector<CsvScan> scans;
  std::unordered_map<std::string_view, std::size_t> index;
  std::vector<std::string_view> cells;
  std::size_t last = 0;  // scan of the line before
  *num_lines = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    std::string_view line = text.substr(begin, end - begin);
    const std::size_t start = begin;
    begin = end;
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
    if (IsCsvComment(line)) continue;
    SplitCells(line, head.delimiter, &cells);
    if (cells.size() != head.names.size()) continue;
    ++*num_lines;
    const auto [entry, is_new] = index.try_emplace(cells[column], scans.size());
    if (is_new) {
      const bool has_time = time_column < cells.size();
      scans.push_back({cells[column], has_time ? cells[time_column] : std::string_view(), {}});
    }
    std::vector<std::string_view>& lines = scans[entry->second].lines;
    if (!lines.empty() && last == entry->second) {
      const std::size_t run = static_cast<std::size_t>(lines.back().data() - text.data());
      lines.back() = text.substr(run, end - run);
    } else {
      lines.push_back(text.substr(start, end - start));
    }
    last = entry->second;
  }
  return scans;
}

}  // namespace

std::optional<CsvDrive> SplitCsvDrive(std::string_view text) {
  TextLines lines(text);
  std::string ignored;
  const std::optional<CsvHead> head = ReadCsvHead(&lines, &ignored);
  if (!head || head->first_line.empty()) return std::nullopt;
  const auto begin = static_cast<std::size_t>(head->first_line.data() - text.data());
  const std::size_t line_begin = text.rfind('\n', begin) + 1;  // npos + 1: the start
  const auto time = std::find_if(head->names.begin(), head->names.end(), NamesTimes);
  const auto time_column = static_cast<std::size_t>(std::distance(head->names.begin(), time));
  for (const bool are_times : {false, true}) {
    for (std::size_t i = 0; i < head->names.size(); ++i) {
      if (!(are_times ? NamesTimes(head->names[i]) : NamesFrames(head->names[i]))) continue;
      std::size_t num_lines = 0;
      std::vector<CsvScan> scans = Group(text, line_begin, *head, i, time_column, &num_lines);
      if (scans.size() < 2 || num_lines < kFewestLines * scans.size()) continue;
      return CsvDrive{
          std::string(head->names[i]), are_times, text.substr(0, line_begin), std::move(scans)};
    }
  }
  return std::nullopt;
}

}  // namespace radive
