// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace radive {

// One setting of an ...Options struct: where its value lives, its unit, its bounds and what it
// means. Each Options struct lists its fields once, in Fields(); range checks (IsValid), YAML
// files, --set, --help_config and the effective configuration in the results all read that list.
struct OptionField {
  // A value out of a fixed set of words, backed by an enum.
  struct Choice {
    std::vector<std::string> names;  // names[i] is the word for the enumerator of value i
    std::function<int()> get;
    std::function<void(int)> set;
  };
  using Value = std::variant<double*, int*, bool*, std::string*, std::vector<double>*, Choice>;

  std::string name;  // without the stage: "d_max"
  Value value;
  std::string unit;  // "m", "m/s", "rad", "-" ...
  std::string doc;   // one sentence

  // Closed bounds for numbers (each entry, for lists). Positive excludes `min` itself.
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool exclude_min = false;
  int list_size = -1;  // required length of a list, -1: any

  OptionField& AtLeast(double low) { return min = low, *this; }
  OptionField& AtMost(double high) { return max = high, *this; }
  OptionField& Above(double low) { return min = low, exclude_min = true, *this; }
  OptionField& Size(int count) { return list_size = count, *this; }

  // True when the value obeys the bounds; otherwise writes "NAME must be RULE, is VALUE".
  // NaN never obeys.
  bool Check(const std::string& stage, std::string* error) const;

  // "> 0", ">= 0 and <= 1", "one of paper | unit"; empty when anything goes.
  std::string Rule() const;

  // The value as YAML text that Parse() of the config layer reads back exactly.
  std::string ToString() const;
};

template <typename Enum>
OptionField::Choice MakeChoice(Enum* value, std::vector<std::string> names) {
  return {std::move(names),
          [value] { return static_cast<int>(*value); },
          [value](int i) { *value = static_cast<Enum>(i); }};
}

// Checks every field; writes the first violation to `error` as "STAGE.NAME must be ...".
bool CheckFields(const std::string& stage,
                 const std::vector<OptionField>& fields,
                 std::string* error);

// IsValid() for an Options struct with Fields(): the list needs a mutable object, so it is taken
// from a copy.
template <typename Options>
bool CheckOptions(const std::string& stage, Options options, std::string* error) {
  return CheckFields(stage, options.Fields(), error);
}

}  // namespace radive
