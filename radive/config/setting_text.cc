// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/config/setting_text.h"

#include <algorithm>
#include <cmath>

#include "radive/util/number_text.h"
#include "radive/util/text.h"

namespace radive {
namespace {

std::string Trim(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool ParseNumber(const std::string& word, double* value) {
  if (word == ".inf" || word == "inf") return *value = HUGE_VAL, true;
  if (word == "-.inf" || word == "-inf") return *value = -HUGE_VAL, true;
  // ParseDouble alone would also take "nan" and "infinity".
  if (word.find_first_not_of("0123456789+-.eE") != std::string::npos) return false;
  const std::optional<double> number = ParseDouble(word);
  *value = number.value_or(0.0);
  return number && std::isfinite(*number);
}

bool ParseInteger(const std::string& word, int* value) {
  const std::optional<int> number = ParseInt(word);
  *value = number.value_or(0);
  return number.has_value();
}

// Assigns one variant alternative each; false: the text is not of that type.
struct Assigner {
  const SettingText& text;

  bool operator()(double* value) const {
    double number = 0.0;
    if (!IsPlainWord() || !ParseNumber(text.words[0], &number)) return false;
    *value = number;
    return true;
  }
  bool operator()(int* value) const {
    int number = 0;
    if (!IsPlainWord() || !ParseInteger(text.words[0], &number)) return false;
    *value = number;
    return true;
  }
  bool operator()(bool* value) const {
    if (!IsPlainWord() || (text.words[0] != "true" && text.words[0] != "false")) return false;
    *value = text.words[0] == "true";
    return true;
  }
  bool operator()(std::string* value) const {
    *value = text.is_list ? text.ToString() : text.words[0];  // a text may well be "[x, y, z]"
    return true;
  }
  bool operator()(std::vector<double>* value) const {
    if (!text.is_list) return false;
    std::vector<double> numbers(text.words.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!ParseNumber(text.words[i], &numbers[i])) return false;
    }
    *value = std::move(numbers);
    return true;
  }
  bool operator()(const OptionField::Choice& choice) const {
    if (text.is_list) return false;
    const auto found = std::find(choice.names.begin(), choice.names.end(), text.words[0]);
    if (found == choice.names.end()) return false;
    choice.set(static_cast<int>(found - choice.names.begin()));
    return true;
  }

 private:
  bool IsPlainWord() const { return !text.is_list && !text.is_quoted; }
};

struct TypeName {
  std::string operator()(const double*) const { return "a number"; }
  std::string operator()(const int*) const { return "a whole number"; }
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const std::string*) const { return "a text"; }
  std::string operator()(const std::vector<double>*) const { return "a list like [1, 2.5, 3]"; }
  std::string operator()(const OptionField::Choice&) const { return ""; }
};

// Number of insertions, deletions, replacements and swaps of neighbours between two words.
std::size_t EditDistance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> cost(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}

}  // namespace

std::string SettingText::ToString() const {
  if (!is_list && words.empty()) return "";
  if (!is_list) return is_quoted ? "\"" + words[0] + "\"" : words[0];
  std::string text = "[";
  for (const std::string& word : words) text += (text.size() > 1 ? ", " : "") + word;
  return text + "]";
}

SettingText ParseSettingText(const std::string& raw) {
  const std::string text = Trim(raw);
  SettingText setting;
  if (text.size() >= 2 && text.front() == '[' && text.back() == ']') {
    setting.is_list = true;
    const std::string inside = Trim(text.substr(1, text.size() - 2));
    for (std::size_t begin = 0; !inside.empty() && begin <= inside.size();) {
      const std::size_t comma = std::min(inside.find(',', begin), inside.size());
      setting.words.push_back(Trim(inside.substr(begin, comma - begin)));
      begin = comma + 1;
    }
    return setting;
  }
  const bool quoted = text.size() >= 2 && text.front() == text.back() &&
                      (text.front() == '"' || text.front() == '\'');
  setting.is_quoted = quoted;
  setting.words.push_back(quoted ? text.substr(1, text.size() - 2) : text);
  return setting;
}

bool AssignField(const std::string& stage,
                 const SettingText& text,
                 OptionField* field,
                 std::string* error) {
  if (std::visit(Assigner{text}, field->value)) return field->Check(stage, error);
  const std::string type = std::visit(TypeName(), field->value);
  const std::string rule = field->Rule();
  *error = stage + "." + field->name + " must be " + type +
           (type.empty() || rule.empty() ? "" : ", ") + rule + ", is " +
           (text.ToString().empty() ? "empty" : Excerpt(text.ToString()));
  if (const auto* choice = std::get_if<OptionField::Choice>(&field->value)) {
    const auto nearest = text.is_list ? std::nullopt : NearestWord(text.words[0], choice->names);
    if (nearest) *error += " (did you mean " + *nearest + "?)";
  }
  return false;
}

std::optional<std::string> NearestWord(const std::string& word,
                                       const std::vector<std::string>& candidates) {
  constexpr std::size_t kLongestWord = 100;  // no typo of a name is longer
  if (word.size() > kLongestWord) return std::nullopt;
  std::optional<std::string> nearest;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = EditDistance(word, candidate);
    // A word that shares nothing with the candidate is no typo of it.
    if (distance < least && distance < std::max(word.size(), candidate.size())) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace radive
