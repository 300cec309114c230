// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/scan_stamps.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>

#include "radive/io/bytes/record_file.h"
#include "radive/io/bytes/stamp_text.h"
#include "radive/io/bytes/text_lines.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

using Texts = std::vector<std::string_view>;

struct Lines {
  std::vector<int> numbers;
  Texts texts;
};

bool IsStamp(std::string_view text) { return ParseDouble(text) || ParseDate(text); }

Texts Columns(std::string_view line) {
  constexpr std::string_view kSeparators = " \t,;";
  Texts columns;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(kSeparators), line.size());
    if (end > 0) columns.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return columns;
}

// The lines that may hold stamps.
Lines LinesOf(std::string_view text, bool is_trajectory) {
  Lines lines;
  TextLines all(text);
  bool is_first = true;
  for (std::string_view line; all.Next(&line);) {
    line = TrimBlanks(line);
    if (line.empty() || line.front() == '#') continue;
    if (is_trajectory) line = line.substr(0, line.find_first_of(" \t"));
    const Texts columns = Columns(line);
    const bool is_header = is_first && !is_trajectory && !ParseDate(line) &&
                           std::none_of(columns.begin(), columns.end(), IsStamp);
    is_first = false;
    if (is_header) continue;
    lines.numbers.push_back(all.number());
    lines.texts.push_back(line);
  }
  return lines;
}

// Seconds since 1970, and the rest in whole ms, us or ns.
bool AreSecondsAndRest(const Texts& seconds, const Texts& rest) {
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    const auto s = ParseCount(seconds[i]);
    const auto part = ParseCount(rest[i]);
    if (!s || !part || *s < 100'000'000 || *s > 9'223'372'035 || rest[i].size() > 9) return false;
  }
  return !seconds.empty();
}

// As of file names: the unit of the rest is the largest that the longest number leaves.
int ExponentOfRest(const Texts& rest) {
  std::size_t longest = 0;
  for (const std::string_view text : rest) longest = std::max(longest, text.size());
  return longest <= 3 ? -3 : longest <= 6 ? -6 : -9;
}

// Of several columns: the stamps. Nothing when no column holds any, or several do.
std::optional<StampSequence> StampsOfColumns(const std::vector<Texts>& columns, double rate) {
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) {
    if (!AreSecondsAndRest(columns[i], columns[i + 1])) continue;
    const int exponent = ExponentOfRest(columns[i + 1]);
    StampSequence sequence;
    sequence.unit = exponent == -3 ? "s and ms" : exponent == -6 ? "s and us" : "s and ns";
    for (std::size_t k = 0; k < columns[i].size(); ++k) {
      sequence.stamps_ns.push_back(*ParseInteger(columns[i][k]) * 1'000'000'000 +
                                   ParseStamp(columns[i + 1][k], exponent).value_or(0));
    }
    return sequence;
  }
  std::optional<StampSequence> found;
  std::size_t bad = 0;
  for (const Texts& column : columns) {
    std::optional<StampSequence> sequence = ReadStampSequence(column, rate, &bad);
    if (!sequence || sequence->rate_is_used || !sequence->doubt.empty()) continue;
    if (found) return std::nullopt;
    found = std::move(sequence);
  }
  return found;
}

}  // namespace

std::optional<std::int64_t> ParseInteger(std::string_view text) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (text.empty() || failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<StampSequence> ParseStampLines(std::string_view text,
                                             bool is_trajectory,
                                             double rate,
                                             const std::string& place,
                                             std::string* error) {
  const Lines lines = LinesOf(text, is_trajectory);
  const auto fail = [&](std::size_t line) {
    *error = place + ":" + std::to_string(lines.numbers[line]) +
             ": expected one stamp per line, a number in s, ms, us or ns, or a date, found " +
             Quoted(lines.texts[line]);
    return std::nullopt;
  };
  std::size_t bad = 0;
  if (is_trajectory) {
    StampSequence sequence;
    sequence.unit = "s";
    for (; bad < lines.texts.size(); ++bad) {
      const std::optional<std::int64_t> stamp = ParseStamp(lines.texts[bad]);
      if (!stamp) return fail(bad);
      sequence.stamps_ns.push_back(*stamp);
    }
    return sequence;
  }
  std::optional<StampSequence> sequence = ReadStampSequence(lines.texts, rate, &bad);
  if (sequence) return sequence;
  const std::size_t num_columns = Columns(lines.texts.front()).size();
  if (num_columns < 2) return fail(bad);
  std::vector<Texts> columns(num_columns);
  for (std::size_t i = 0; i < lines.texts.size(); ++i) {
    const Texts cells = Columns(lines.texts[i]);
    if (cells.size() != num_columns) return fail(i);
    for (std::size_t k = 0; k < num_columns; ++k) columns[k].push_back(cells[k]);
  }
  sequence = StampsOfColumns(columns, rate);
  if (!sequence) return fail(bad);
  return sequence;
}

std::optional<StampSequence> ReadStampFile(const std::filesystem::path& path,
                                           double rate,
                                           std::string* error) {
  std::string text;
  if (!ReadWholeFile(path, &text, error)) return std::nullopt;
  return ParseStampLines(text, path.filename() == "ref_poses.txt", rate, path.string(), error);
}

}  // namespace radive
