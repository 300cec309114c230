// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/util/option_field.h"

#include <cmath>

#include "radive/util/number_text.h"
#include "radive/util/text.h"

namespace radive {
namespace {

// The shortest text that reads back as the same double.
std::string ShortestText(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0 ? ".inf" : "-.inf";
  std::string text;
  for (int digits = 6; digits <= 17 && ParseDouble(text) != value; ++digits) {
    text = FormatText("%.*g", digits, value);
  }
  return text;
}

// A double-quoted YAML string.
std::string QuotedText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n') {
      quoted += "\\n";
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

bool InBounds(const OptionField& field, double value) {
  const bool above = field.exclude_min ? value > field.min : value >= field.min;
  return above && value <= field.max;
}

}  // namespace

std::string OptionField::Rule() const {
  std::string rule;
  if (const auto* choice = std::get_if<Choice>(&value)) {
    for (const std::string& name_of_value : choice->names) {
      rule += (rule.empty() ? "one of " : " | ") + name_of_value;
    }
    return rule;
  }
  if (std::isfinite(min)) rule = (exclude_min ? "> " : ">= ") + ShortestText(min);
  if (std::isfinite(max)) rule += (rule.empty() ? "<= " : " and <= ") + ShortestText(max);
  if (list_size >= 0) {
    rule = std::to_string(list_size) + " numbers" + (rule.empty() ? "" : ", each " + rule);
  }
  return rule;
}

std::string OptionField::ToString() const {
  struct Printer {
    std::string operator()(const double* v) const { return ShortestText(*v); }
    std::string operator()(const int* v) const { return std::to_string(*v); }
    std::string operator()(const bool* v) const { return *v ? "true" : "false"; }
    std::string operator()(const std::string* v) const { return QuotedText(*v); }
    std::string operator()(const std::vector<double>* v) const {
      std::string text = "[";
      for (const double entry : *v) text += (text.size() > 1 ? ", " : "") + ShortestText(entry);
      return text + "]";
    }
    std::string operator()(const Choice& v) const {
      return v.names[static_cast<std::size_t>(v.get())];
    }
  };
  return std::visit(Printer(), value);
}

bool OptionField::Check(const std::string& stage, std::string* error) const {
  bool ok = true;
  if (const auto* number = std::get_if<double*>(&value)) {
    ok = InBounds(*this, **number);
  } else if (const auto* integer = std::get_if<int*>(&value)) {
    ok = InBounds(*this, **integer);
  } else if (const auto* list = std::get_if<std::vector<double>*>(&value)) {
    ok = list_size < 0 || (*list)->size() == static_cast<std::size_t>(list_size);
    for (const double entry : **list) ok = ok && InBounds(*this, entry);
  } else if (const auto* choice = std::get_if<Choice>(&value)) {
    ok = choice->get() >= 0 && choice->get() < static_cast<int>(choice->names.size());
    if (!ok) {
      *error = stage + "." + name + " must be " + Rule();
      return false;
    }
  }
  if (ok) return true;
  const std::string unit_text = unit.empty() || unit == "-" ? "" : " " + unit;
  *error = stage + "." + name + " must be " + Rule() + unit_text + ", is " + Excerpt(ToString());
  return false;
}

bool CheckFields(const std::string& stage,
                 const std::vector<OptionField>& fields,
                 std::string* error) {
  for (const OptionField& field : fields) {
    if (!field.Check(stage, error)) return false;
  }
  return true;
}

}  // namespace radive
