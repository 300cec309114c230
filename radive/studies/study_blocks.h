// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <yaml-cpp/yaml.h>

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// Reads the blocks "key: value" of a study file. All functions return false with "FILE:LINE: what
// is wrong" in the error that was given to the constructor.
class StudyBlocks {
 public:
  // Reads the value of a key that is no plain setting; `mark` is where the key stands.
  using ReadSpecial =
      std::function<bool(const std::string& key, const YAML::Node& value, const YAML::Mark& mark)>;

  StudyBlocks(std::string file, std::string* error) : file_(std::move(file)), error_(error) {}

  // Says that something is wrong at `mark`.
  bool Fail(const YAML::Mark& mark, const std::string& message) const;

  // "FILE:LINE: "
  std::string Place(const YAML::Mark& mark) const;

  // Writes the settings of `block` into `fields`; the keys in `special` go to `read` instead.
  bool Read(const YAML::Node& block,
            const std::string& name,
            std::vector<OptionField> fields,
            const std::set<std::string>& special = {},
            const ReadSpecial& read = nullptr) const;

  // Lines "stage.field: value" of a run's configuration, to the text that --set takes.
  bool ReadSet(const YAML::Node& block, const YAML::Mark& mark, std::string* set) const;

  // A number, a range 0-4 or a list [0, 1, 2] without repetition.
  bool ReadSeeds(const YAML::Node& node,
                 const std::string& key,
                 const YAML::Mark& mark,
                 std::vector<int>* seeds) const;

  // A list of names.
  bool ReadNames(const YAML::Node& node,
                 const std::string& key,
                 const YAML::Mark& mark,
                 std::vector<std::string>* names) const;

 private:
  const std::string file_;
  std::string* const error_;
};

}  // namespace radive
