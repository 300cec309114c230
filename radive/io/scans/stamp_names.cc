// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/stamp_names.h"

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "radive/io/bytes/stamp_text.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

// The runs of digits of a name, and what is between them: separators[i] in front of digits[i].
struct Tokens {
  std::vector<std::string_view> digits, separators;
};

Tokens TokensOf(std::string_view stem) {
  Tokens tokens;
  constexpr std::string_view kDigits = "0123456789";
  while (!stem.empty()) {
    const std::size_t begin = stem.find_first_of(kDigits);
    if (begin == std::string_view::npos) break;
    tokens.separators.push_back(stem.substr(0, begin));
    stem.remove_prefix(begin);
    const std::size_t end = std::min(stem.find_first_not_of(kDigits), stem.size());
    tokens.digits.push_back(stem.substr(0, end));
    stem.remove_prefix(end);
  }
  return tokens;
}

std::string_view Digits(const Tokens& tokens, std::size_t i) {
  return i < tokens.digits.size() ? tokens.digits[i] : std::string_view();
}

std::string_view Separator(const Tokens& tokens, std::size_t i) {
  return i < tokens.separators.size() ? tokens.separators[i] : std::string_view();
}

// Whole seconds since 1970 with ten digits: 2001 to 2286.
bool AreSeconds(std::string_view digits) { return digits.size() == 10 && digits.front() != '0'; }

// The ways in which the digits from run `i` on may be a stamp. Each gives nothing for other names.
using Form = std::optional<std::int64_t> (*)(const Tokens& tokens, std::size_t i, int unit);

std::optional<std::int64_t> WholeNumber(const Tokens& tokens, std::size_t i, int /*unit*/) {
  const std::string_view digits = Digits(tokens, i);
  if (digits.empty() || digits.front() == '0') return std::nullopt;
  switch (digits.size()) {
    case 18:
    case 19:
      return ParseStamp(digits, -9);
    case 15:
    case 16:
      return ParseStamp(digits, -6);
    case 12:
    case 13:
      return ParseStamp(digits, -3);
    default:
      return std::nullopt;
  }
}

std::optional<std::int64_t> WholeSeconds(const Tokens& tokens, std::size_t i, int /*unit*/) {
  const std::string_view digits = Digits(tokens, i);
  return AreSeconds(digits) ? ParseStamp(digits) : std::nullopt;
}

// 1700000000.123456
std::optional<std::int64_t> WithFraction(const Tokens& tokens, std::size_t i, int /*unit*/) {
  if (!AreSeconds(Digits(tokens, i)) || Separator(tokens, i + 1) != ".") return std::nullopt;
  return ParseStamp(std::string(tokens.digits[i]) + "." + std::string(tokens.digits[i + 1]));
}

// 1700000000_123456789; the second number counts units of 10^unit s, with leading zeros or without.
std::optional<std::int64_t> SecondsAndRest(const Tokens& tokens, std::size_t i, int unit) {
  const std::string_view separator = Separator(tokens, i + 1);
  if (!AreSeconds(Digits(tokens, i)) || (separator != "_" && separator != "-")) return std::nullopt;
  const std::string_view rest = Digits(tokens, i + 1);
  if (rest.empty() || rest.size() > static_cast<std::size_t>(-unit)) return std::nullopt;
  const auto seconds = ParseStamp(tokens.digits[i]);
  const auto part = ParseStamp(rest, unit);
  if (!seconds || !part) return std::nullopt;
  return *seconds + *part;
}

// 2023-11-14-22-13-20 and 20231114_221320, with or without a fraction of 1 to 9 digits behind.
std::optional<std::int64_t> DateAndTime(const Tokens& tokens, std::size_t i, int unit) {
  std::string date;
  std::size_t next = i;
  const std::string_view first = Digits(tokens, i);
  if (first.size() == 4) {
    for (int part = 0; part < 6; ++part, ++next) {
      const std::string_view digits = Digits(tokens, next);
      if (digits.size() != (part == 0 ? 4u : 2u)) return std::nullopt;
      if (part > 0 && Separator(tokens, next).size() != 1) return std::nullopt;
      date += std::string(part == 0 ? "" : "-") + std::string(digits);
    }
  } else {
    std::string digits(first);
    ++next;
    if (digits.size() == 8) digits += std::string(Digits(tokens, next++));
    if (digits.size() < 14) return std::nullopt;
    date = digits.substr(0, 4);
    for (std::size_t k = 4; k < 14; k += 2) date += "-" + digits.substr(k, 2);
    if (digits.size() > 14) date += "." + digits.substr(14);
  }
  if (unit != 0) {  // with a fraction in a run of its own
    const std::string_view fraction = Digits(tokens, next);
    if (Separator(tokens, next).size() != 1 || fraction.size() > 9) return std::nullopt;
    date += "." + std::string(fraction);
  }
  return ParseDate(date);
}

// 12.345: seconds from the start of the drive. Only where the name is nothing else.
std::optional<std::int64_t> FromStart(const Tokens& tokens, std::size_t i, int /*unit*/) {
  const bool is_all = tokens.digits.size() == 2 && i == 0 && tokens.separators[0].empty();
  if (!is_all || tokens.separators[1] != ".") return std::nullopt;
  return ParseStamp(std::string(tokens.digits[0]) + "." + std::string(tokens.digits[1]));
}

struct Candidate {
  std::vector<std::int64_t> stamps_ns;
  std::size_t num_read = 0;
  std::size_t num_different = 0;
  std::optional<std::size_t> odd;  // the first that is none
};

Candidate Read(const std::vector<Tokens>& names, Form form, std::size_t i, int unit) {
  Candidate candidate;
  std::unordered_set<std::int64_t> different;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::optional<std::int64_t> stamp = form(names[k], i, unit);
    if (stamp) {
      candidate.stamps_ns.push_back(*stamp);
      different.insert(*stamp);
    } else if (!candidate.odd) {
      candidate.odd = k;
    }
  }
  candidate.num_read = candidate.stamps_ns.size();
  candidate.num_different = different.size();
  return candidate;
}

struct FormOfStamp {
  Form form;
  int unit;
  const char* name;
};
// Of forms that fit equally well the first counts.
constexpr FormOfStamp kForms[] = {{WholeNumber, 0, "digits"},
                                  {SecondsAndRest, -3, "s and ms"},
                                  {SecondsAndRest, -6, "s and us"},
                                  {SecondsAndRest, -9, "s and ns"},
                                  {WithFraction, 0, "s"},
                                  {DateAndTime, 1, "dates"},
                                  {DateAndTime, 0, "dates"},
                                  {WholeSeconds, 0, "s"},
                                  {FromStart, 0, "s"}};

// Whether the longest of the numbers behind the seconds has as many digits as the unit needs.
bool IsOfUnit(const std::vector<Tokens>& names, std::size_t i, int unit) {
  std::size_t longest = 0;
  for (const Tokens& tokens : names) longest = std::max(longest, Digits(tokens, i + 1).size());
  const auto digits = static_cast<std::size_t>(-unit);
  return longest <= digits && longest > digits - 3;
}

bool Fits(const FormOfStamp& form, const std::vector<Tokens>& names, std::size_t i) {
  if (form.form == FromStart) {
    // Version numbers and the like do not go on in a radar's interval.
    Candidate candidate = Read(names, form.form, i, form.unit);
    std::sort(candidate.stamps_ns.begin(), candidate.stamps_ns.end());
    if (candidate.stamps_ns.size() < 3) return false;
    const double mean = static_cast<double>(candidate.stamps_ns.back() - candidate.stamps_ns[0]) *
                        1e-9 / static_cast<double>(candidate.stamps_ns.size() - 1);
    return mean >= 0.01 && mean <= 1.0;
  }
  if (form.form != SecondsAndRest) return true;
  const bool is_point = std::any_of(names.begin(), names.end(), [&](const Tokens& tokens) {
    return Separator(tokens, i + 1) == ".";
  });
  return !is_point && IsOfUnit(names, i, form.unit);  // with a point it is a fraction
}

}  // namespace

std::optional<StampSequence> StampsOfNames(const std::vector<std::string>& stems,
                                           std::optional<std::size_t>* odd) {
  odd->reset();
  std::vector<Tokens> names;
  std::size_t num_tokens = 0;
  for (const std::string& stem : stems) {
    names.push_back(TokensOf(stem));
    num_tokens = std::max(num_tokens, names.back().digits.size());
  }
  Candidate best;
  const char* unit = "";
  for (std::size_t i = 0; i < std::min<std::size_t>(num_tokens, 16); ++i) {
    for (const FormOfStamp& form : kForms) {
      if (!Fits(form, names, i)) continue;
      Candidate candidate = Read(names, form.form, i, form.unit);
      const auto rank = [](const Candidate& c) { return std::pair(c.num_different, c.num_read); };
      if (rank(candidate) <= rank(best)) continue;
      best = std::move(candidate);
      unit = form.name;
    }
  }
  if (best.num_read == 0) return std::nullopt;
  // A date that all names share is that of the recording.
  if (stems.size() > 1 && 2 * best.num_different <= best.num_read) return std::nullopt;
  if (best.odd) {
    *odd = best.odd;
    return std::nullopt;
  }
  StampSequence sequence;
  sequence.stamps_ns = std::move(best.stamps_ns);
  sequence.unit = unit;
  return sequence;
}

}  // namespace radive
