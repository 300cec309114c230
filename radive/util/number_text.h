// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

// Numbers to and from text, the same in every locale. No other file of the library may use
// printf(), strtod() and the like with numbers: scripts/check_layers.py looks for them.

namespace radive {

// What printf() would print in the "C" locale, of any length.
[[gnu::format(printf, 1, 2)]] std::string FormatText(const char* form, ...);

// A number in a message, with six decimals.
inline std::string NumberText(double value) { return FormatText("%f", value); }

// Nine digits at most, as "%.9g" has them.
std::string ShortText(double value);

// What Microsoft's C library printed until 2015: 1.#QNAN, -1.#IND, 1.#SNAN, 1.#INF, perhaps with
// zeros behind.
inline std::optional<double> ParseMicrosoftWord(std::string_view text) {
  const bool is_negative = !text.empty() && text.front() == '-';
  if (is_negative) text.remove_prefix(1);
  while (!text.empty() && text.back() == '0') text.remove_suffix(1);
  if (text == "1.#INF") {
    const double infinity = std::numeric_limits<double>::infinity();
    return is_negative ? -infinity : infinity;
  }
  if (text == "1.#QNAN" || text == "1.#IND" || text == "1.#SNAN") {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::nullopt;
}

// A decimal number that is all of `text`; "nan", "inf" and their kin of Microsoft's count. Beyond
// the largest double it is infinite, below the smallest 0. Nothing for anything else.
inline std::optional<double> ParseDouble(std::string_view text) {
  const char* const end = text.data() + text.size();
  const char* begin = text.data();
  if (!text.empty() && text.front() == '+') ++begin;
  if (begin == end || (begin != text.data() && *begin == '-')) return std::nullopt;
  double value = 0.0;
  const auto [stop, failure] = std::from_chars(begin, end, value);
  if (stop != end) return ParseMicrosoftWord(text);
  if (failure == std::errc()) return value;
  if (failure != std::errc::result_out_of_range) return std::nullopt;
  const std::size_t exponent = text.find_first_of("eE");
  const bool is_tiny =
      exponent == std::string_view::npos || text.substr(exponent).find('-') != text.npos;
  const double size = is_tiny ? 0.0 : std::numeric_limits<double>::infinity();
  return *begin == '-' ? -size : size;
}

// A whole number that is all of `text`, with or without a sign, within the bounds of an int.
inline std::optional<int> ParseInt(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (text.empty() || failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

// A whole number from 0 that is all of `text`.
inline std::optional<std::uint64_t> ParseCount(std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, value);
  if (text.empty() || failure != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace radive
