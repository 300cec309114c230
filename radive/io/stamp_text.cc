// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/stamp_text.h"

#include <charconv>
#include <cstddef>
#include <limits>
#include <system_error>

#include "radive/io/record_file.h"
#include "radive/io/text_lines.h"

namespace radive {
namespace {

constexpr int kDecimalsOfNanoseconds = 9;

// Splits "12.5e-3" into sign, digits "125" and the number of digits before the point (-1 here:
// 0.0125). False when it is no decimal number.
bool SplitDecimal(std::string_view text, bool* negative, std::string* digits, std::int64_t* point) {
  *negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  std::int64_t exponent = 0;
  if (const std::size_t e = text.find_first_of("eE"); e != std::string_view::npos) {
    std::string_view exponent_text = text.substr(e + 1);
    if (!exponent_text.empty() && exponent_text.front() == '+') {
      exponent_text.remove_prefix(1);
      if (!exponent_text.empty() && exponent_text.front() == '-') return false;
    }
    const std::optional<std::int64_t> parsed = ParseInteger(exponent_text);
    // Far beyond any time; the limit keeps the padding with zeros below short.
    if (!parsed || *parsed > 99 || *parsed < -99) return false;
    exponent = *parsed;
    text = text.substr(0, e);
  }
  std::optional<std::int64_t> before_point;
  digits->clear();
  for (const char c : text) {
    if (c == '.' && !before_point) {
      before_point = static_cast<std::int64_t>(digits->size());
    } else if (c >= '0' && c <= '9') {
      *digits += c;
    } else {
      return false;
    }
  }
  *point = before_point.value_or(static_cast<std::int64_t>(digits->size())) + exponent;
  return !digits->empty();
}

}  // namespace

std::optional<std::int64_t> ParseInteger(std::string_view text) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (text.empty() || failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<std::int64_t> ParseSeconds(std::string_view text) {
  bool negative = false;
  std::string digits;
  std::int64_t point = 0;
  if (!SplitDecimal(text, &negative, &digits, &point)) return std::nullopt;

  // `point` now becomes the number of digits of the value in nanoseconds.
  point += kDecimalsOfNanoseconds;
  if (point < 0) return 0;
  const std::size_t whole = static_cast<std::size_t>(point);
  const bool round_up = whole < digits.size() && digits[whole] >= '5';
  digits.resize(whole, '0');
  const std::optional<std::int64_t> value = ParseInteger(digits.empty() ? "0" : digits);
  if (!value || *value == std::numeric_limits<std::int64_t>::max()) return std::nullopt;
  const std::int64_t magnitude = *value + (round_up ? 1 : 0);
  return negative ? -magnitude : magnitude;
}

bool ReadStampFile(const std::filesystem::path& path,
                   std::vector<std::int64_t>* stamps_ns,
                   std::string* error) {
  std::string text;
  if (!ReadWholeFile(path, &text, error)) return false;
  struct Entry {
    int line;
    std::string_view text;
  };
  std::vector<Entry> entries;
  bool are_seconds = false;
  TextLines lines(text);
  for (std::string_view line; lines.Next(&line);) {
    line = TrimBlanks(line);
    if (line.empty() || line.front() == '#') continue;
    are_seconds = are_seconds || line.find_first_of(".eE") != std::string_view::npos;
    entries.push_back({lines.number(), line});
  }
  stamps_ns->clear();
  for (const Entry& entry : entries) {
    const std::optional<std::int64_t> stamp =
        are_seconds ? ParseSeconds(entry.text) : ParseInteger(entry.text);
    if (!stamp) {
      *error = path.string() + ":" + std::to_string(entry.line) +
               ": expected one stamp, integer nanoseconds or decimal seconds, found " +
               Quoted(entry.text);
      return false;
    }
    stamps_ns->push_back(*stamp);
  }
  return true;
}

std::optional<std::int64_t> StampOfStem(std::string_view stem) {
  if (stem.empty() || stem.front() < '1' || stem.front() > '9') return std::nullopt;
  const std::optional<std::int64_t> value = ParseInteger(stem);
  if (!value) return std::nullopt;
  switch (stem.size()) {
    case 18:
    case 19:
      return *value;
    case 15:
    case 16:
      return *value * 1000;
    case 12:
    case 13:
      return *value * 1000000;
    default:
      return std::nullopt;
  }
}

}  // namespace radive
