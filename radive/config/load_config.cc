// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/config/load_config.h"

#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "radive/config/setting_text.h"

namespace radive {
namespace {

using Stages = std::vector<std::pair<std::string, std::vector<OptionField>>>;

std::string Suggestion(const std::string& word, const std::vector<std::string>& candidates) {
  const std::optional<std::string> nearest = NearestWord(word, candidates);
  return nearest ? ", did you mean " + *nearest + "?" : "";
}

std::vector<OptionField>* FindStage(const std::string& name, Stages* stages, std::string* error) {
  std::vector<std::string> names;
  std::string list;
  for (auto& [stage, fields] : *stages) {
    if (stage == name) return &fields;
    names.push_back(stage);
    list += (list.empty() ? "" : ", ") + stage;
  }
  const std::string suggestion = Suggestion(name, names);
  *error = "unknown stage " + name + (suggestion.empty() ? "; the stages are " + list : suggestion);
  return nullptr;
}

// Null when `stage` has no field `name`: then looks whether it stands under the wrong stage, then
// for typing errors in this one.
OptionField* FindField(const std::string& stage,
                       const std::string& name,
                       Stages* stages,
                       std::string* error) {
  std::vector<OptionField>* fields = FindStage(stage, stages, error);
  if (fields == nullptr) return nullptr;
  std::vector<std::string> names;
  for (OptionField& field : *fields) {
    if (field.name == name) return &field;
    names.push_back(field.name);
  }
  *error = "unknown key " + stage + "." + name;
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

std::string PlaceOf(const std::string& file, const YAML::Mark& mark) {
  return mark.is_null() ? file + ": " : file + ":" + std::to_string(mark.line + 1) + ": ";
}

// False for maps, and lists of anything but plain values.
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

bool ApplyStage(const std::string& file,
                const std::string& stage,
                const YAML::Node& settings,
                Stages* stages,
                std::string* error) {
  std::set<std::string> seen;
  for (const auto& entry : settings) {
    const std::string place = PlaceOf(file, entry.first.Mark());
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
    if (!seen.insert(key).second) {
      *error = place + stage + "." + key + " is set twice";
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

bool ApplyYaml(const std::string& file,
               const YAML::Node& root,
               Stages* stages,
               std::string* error) {
  if (root.IsNull()) return true;  // an empty file, or one of comments alone
  if (!root.IsMap()) {
    *error = PlaceOf(file, root.Mark()) + "expected stages (\"registration:\") with their settings";
    return false;
  }
  std::set<std::string> seen;
  for (const auto& entry : root) {
    const std::string place = PlaceOf(file, entry.first.Mark());
    const std::string stage = entry.first.IsScalar() ? entry.first.Scalar() : "?";
    if (!seen.insert(stage).second) {
      *error = place + "stage " + stage + " appears twice";
      return false;
    }
    if (FindStage(stage, stages, error) == nullptr) {
      *error = place + *error;
      return false;
    }
    if (entry.second.IsNull()) continue;
    if (!entry.second.IsMap()) {
      *error = place + "stage " + stage + " must hold indented lines \"key: value\"";
      return false;
    }
    if (!ApplyStage(file, stage, entry.second, stages, error)) return false;
  }
  return true;
}

// "a.b=1,c.d=[1,2]" to its settings: commas inside brackets and quotes belong to the value.
std::vector<std::string> SplitSettings(const std::string& text) {
  std::vector<std::string> settings(1);
  int depth = 0;
  char quote = '\0';
  for (const char c : text) {
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[') {
      ++depth;
    } else if (c == ']') {
      --depth;
    } else if (c == ',' && depth <= 0) {
      settings.emplace_back();
      continue;
    }
    settings.back() += c;
  }
  return settings;
}

bool ApplySet(const std::string& set_text, Stages* stages, std::string* error) {
  for (const std::string& raw : SplitSettings(set_text)) {
    const std::size_t first = raw.find_first_not_of(" \t");
    if (first == std::string::npos) continue;  // "a.b=1,"
    const std::string setting = raw.substr(first);
    const std::size_t equals = setting.find('=');
    const std::size_t dot = setting.substr(0, equals).find('.');
    if (equals == std::string::npos || dot == std::string::npos) {
      *error = "--set: expected stage.field=value, got \"" + setting + "\"";
      return false;
    }
    const std::string stage = setting.substr(0, dot);
    const std::string key = setting.substr(dot + 1, equals - dot - 1);
    OptionField* field = FindField(stage, key, stages, error);
    if (field == nullptr ||
        !AssignField(stage, ParseSettingText(setting.substr(equals + 1)), field, error)) {
      *error = "--set: " + *error;
      return false;
    }
  }
  return true;
}

bool ReadText(const std::string& path,
              const std::string& what,
              std::string* text,
              std::string* error) {
  std::error_code ignored;
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path, ignored)) {
    *error =
        path + ": cannot read the " + what + ": " + (file ? "is a folder" : std::strerror(errno));
    return false;
  }
  std::stringstream buffer;
  buffer << file.rdbuf();
  *text = buffer.str();
  return true;
}

// Reads the file that neural_map.decoder_file names.
bool ReadDecoder(NeuralMapOptions* options, std::string* error) {
  if (options->decoder_file.empty()) return true;
  std::string text;
  if (!ReadText(options->decoder_file, "decoder file", &text, error)) return false;
  const auto decoder = SdfDecoder::FromText(text, options->decoder_file, error);
  if (decoder) options->decoder = std::make_shared<const SdfDecoder>(*decoder);
  return decoder.has_value();
}

}  // namespace

std::optional<RunConfig> ParseRunConfig(const std::string& yaml_text,
                                        const std::string& place,
                                        const std::string& set_text,
                                        std::string* error) {
  RunConfig config;
  Stages stages = config.Stages();
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(yaml_text);
    if (documents.size() > 1) {
      *error = PlaceOf(place, documents[1].Mark()) + "expected one YAML document, not several";
      return std::nullopt;
    }
    if (!documents.empty() && !ApplyYaml(place, documents[0], &stages, error)) return std::nullopt;
  } catch (const YAML::Exception& exception) {
    *error = PlaceOf(place, exception.mark) + "not valid YAML: " + exception.msg;
    return std::nullopt;
  }
  if (!ApplySet(set_text, &stages, error)) return std::nullopt;
  if (config.input.radar == "all") config.odometry.motion.body = MotionOptions::Body::kVehicle;
  if (!ReadDecoder(&config.odometry.neural_map, error) || !config.IsValid(error)) {
    return std::nullopt;
  }
  return config;
}

std::optional<RunConfig> LoadRunConfig(const std::string& yaml_path,
                                       const std::string& set_text,
                                       std::string* error) {
  std::string yaml_text;
  if (!yaml_path.empty()) {
    if (!ReadText(yaml_path, "configuration file", &yaml_text, error)) return std::nullopt;
  }
  return ParseRunConfig(yaml_text, yaml_path, set_text, error);
}

}  // namespace radive
