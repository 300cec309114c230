// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/bytes/stamp_text.h"

#include <charconv>
#include <cstdlib>

#include "radive/util/number_text.h"

namespace radive {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// digits * 10^exponent, the digits without sign and point.
struct Decimal {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

std::optional<Decimal> ParseDecimal(std::string_view text) {
  Decimal decimal;
  std::size_t i = 0;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) decimal.negative = text[i++] == '-';
  bool after_point = false;
  for (; i < text.size() && (IsDigit(text[i]) || (text[i] == '.' && !after_point)); ++i) {
    if (text[i] == '.') {
      after_point = true;
      continue;
    }
    decimal.digits += text[i];
    if (after_point) --decimal.exponent;
  }
  if (decimal.digits.empty()) return std::nullopt;
  if (i == text.size()) return decimal;

  if (text[i] != 'e' && text[i] != 'E') return std::nullopt;
  ++i;
  if (i + 1 < text.size() && text[i] == '+' && IsDigit(text[i + 1])) ++i;
  int exponent = 0;
  const char* end = text.data() + text.size();
  const auto [rest, code] = std::from_chars(text.data() + i, end, exponent);
  if (code != std::errc() || rest != end || std::abs(exponent) > 1000) return std::nullopt;
  decimal.exponent += exponent;
  return decimal;
}

}  // namespace

std::optional<std::int64_t> ParseStamp(std::string_view text, int unit_exponent) {
  std::optional<Decimal> decimal = ParseDecimal(text);
  if (!decimal) return std::nullopt;

  // Move the point so that the digits count nanoseconds, then cut or fill.
  const int shift = decimal->exponent + unit_exponent + 9;
  std::string& digits = decimal->digits;
  digits.erase(0, digits.find_first_not_of('0'));
  if (digits.empty()) return 0;
  bool round_up = false;
  if (shift >= 0) {
    if (digits.size() + static_cast<std::size_t>(shift) > 19) return std::nullopt;
    digits.append(static_cast<std::size_t>(shift), '0');
  } else {
    const std::size_t cut = static_cast<std::size_t>(-shift);
    if (cut > digits.size()) return 0;
    round_up = digits[digits.size() - cut] >= '5';
    digits.resize(digits.size() - cut);
  }

  std::int64_t nanoseconds = 0;
  if (!digits.empty()) {
    const char* end = digits.data() + digits.size();
    const auto [rest, code] = std::from_chars(digits.data(), end, nanoseconds);
    if (code != std::errc() || rest != end) return std::nullopt;
  }
  if (nanoseconds > kLatestStamp - (round_up ? 1 : 0)) return std::nullopt;
  if (round_up) ++nanoseconds;
  return decimal->negative ? -nanoseconds : nanoseconds;
}

bool LooksLikeNanoseconds(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  // As NumPy prints whole numbers in a table: 1.403636579758555392e+18.
  if (text.find_first_of("eE") != std::string_view::npos) {
    return ParseDouble(text).value_or(0.0) >= 1e17;
  }
  if (text.size() <= 15) return false;
  for (const char c : text) {
    if (!IsDigit(c)) return false;
  }
  return true;
}

std::string FormatStamp(std::int64_t stamp_ns) {
  // Division truncates towards zero, so the sign is written apart.
  return FormatText("%s%lld.%09lld",
                    stamp_ns < 0 ? "-" : "",
                    std::llabs(stamp_ns / 1'000'000'000),
                    std::llabs(stamp_ns % 1'000'000'000));
}

}  // namespace radive
