// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/config/yaml_settings.h"

#include <optional>
#include <set>

#include "radive/util/read_file.h"
#include "radive/util/text.h"

namespace radive {
namespace {

std::string Suggestion(const std::string& word, const std::vector<std::string>& candidates) {
  const std::optional<std::string> nearest = NearestWord(word, candidates);
  return nearest ? ", did you mean " + *nearest + "?" : "";
}

}  // namespace

std::vector<OptionField>* FindStage(const std::string& name,
                                    SettingStages* stages,
                                    std::string* error) {
  std::vector<std::string> names;
  std::string list;
  for (auto& [stage, fields] : *stages) {
    if (stage == name) return &fields;
    names.push_back(stage);
    list += (list.empty() ? "" : ", ") + stage;
  }
  const std::string suggestion = Suggestion(name, names);
  *error = "unknown stage " + Excerpt(name) +
           (suggestion.empty() ? "; the stages are " + list : suggestion);
  return nullptr;
}

// Looks for the name in this stage first, then whether it stands under the wrong stage, then for
// typing errors.
OptionField* FindField(const std::string& stage,
                       const std::string& name,
                       SettingStages* stages,
                       std::string* error) {
  std::vector<OptionField>* fields = FindStage(stage, stages, error);
  if (fields == nullptr) return nullptr;
  std::vector<std::string> names;
  for (OptionField& field : *fields) {
    if (field.name == name) return &field;
    names.push_back(field.name);
  }
  *error = "unknown key " + stage + "." + Excerpt(name);
  for (const auto& [other, other_fields] : *stages) {
    for (const OptionField& field : other_fields) {
      if (field.name == name) {
        *error += ", did you mean " + other + "." + name + "?";
        return nullptr;
      }
    }
  }
  const std::string suggestion = Suggestion(name, names);
  if (!suggestion.empty()) {
    *error += ", did you mean " + stage + "." + *NearestWord(name, names) + "?";
    return nullptr;
  }
  *error += "; --help_config lists all keys";
  return nullptr;
}

std::string PlaceInYaml(const std::string& file, const YAML::Mark& mark) {
  return mark.is_null() ? file + ": " : file + ":" + std::to_string(mark.line + 1) + ": ";
}

bool ToSettingText(const YAML::Node& node, SettingText* text) {
  if (node.IsNull()) {
    text->words = {""};
    return true;
  }
  if (node.IsScalar()) {
    text->is_quoted = node.Tag() == "!";
    text->words = {node.Scalar()};
    return true;
  }
  if (!node.IsSequence()) return false;
  text->is_list = true;
  for (const YAML::Node& entry : node) {
    if (!entry.IsScalar()) return false;
    text->words.push_back(entry.Scalar());
  }
  return true;
}

bool ApplyYamlStage(const std::string& file,
                    const std::string& stage,
                    const YAML::Node& settings,
                    SettingStages* stages,
                    std::string* error) {
  std::set<std::string> seen;
  for (const auto& entry : settings) {
    const std::string place = PlaceInYaml(file, entry.first.Mark());
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
    if (!seen.insert(key).second) {
      *error = place + stage + "." + Excerpt(key) + " is set twice";
      return false;
    }
    OptionField* field = FindField(stage, key, stages, error);
    SettingText text;
    if (field != nullptr && !ToSettingText(entry.second, &text)) {
      *error = stage + "." + key + " must be a value or a list of values, is a block";
      field = nullptr;
    }
    if (field == nullptr || !AssignField(stage, text, field, error)) {
      *error = place + *error;
      return false;
    }
  }
  return true;
}

bool ReadTextFile(const std::string& path,
                  const std::string& what,
                  std::uintmax_t max_bytes,
                  std::string* text,
                  std::string* error) {
  std::string reason;
  if (ReadFileBytes(path, max_bytes, text, &reason)) return true;
  *error = path + ": cannot read the " + what + ": " + reason;
  return false;
}

}  // namespace radive
