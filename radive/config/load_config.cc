// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/config/load_config.h"

#include <yaml-cpp/yaml.h>

#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "radive/config/setting_text.h"
#include "radive/config/yaml_settings.h"
#include "radive/util/text.h"

namespace radive {
namespace {

bool ApplyYaml(const std::string& file,
               const YAML::Node& root,
               SettingStages* stages,
               std::string* error) {
  if (root.IsNull()) return true;  // an empty file, or one of comments alone
  if (!root.IsMap()) {
    *error =
        PlaceInYaml(file, root.Mark()) + "expected stages (\"registration:\") with their settings";
    return false;
  }
  std::set<std::string> seen;
  for (const auto& entry : root) {
    const std::string place = PlaceInYaml(file, entry.first.Mark());
    const std::string stage = entry.first.IsScalar() ? entry.first.Scalar() : "?";
    if (!seen.insert(stage).second) {
      *error = place + "stage " + Excerpt(stage) + " appears twice";
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
    if (!ApplyYamlStage(file, stage, entry.second, stages, error)) return false;
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

bool ApplySet(const std::string& set_text, SettingStages* stages, std::string* error) {
  for (const std::string& raw : SplitSettings(set_text)) {
    const std::size_t first = raw.find_first_not_of(" \t");
    if (first == std::string::npos) continue;  // "a.b=1,"
    const std::string setting = raw.substr(first);
    const std::size_t equals = setting.find('=');
    const std::size_t dot = setting.substr(0, equals).find('.');
    if (equals == std::string::npos || dot == std::string::npos) {
      *error = "--set: expected stage.field=value, got \"" + Excerpt(setting) + "\"";
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

// Reads the file that neural_map.decoder_file names.
bool ReadDecoder(NeuralMapOptions* options, std::string* error) {
  if (options->decoder_file.empty()) return true;
  std::string text;
  if (!ReadTextFile(options->decoder_file, "decoder file", kLargestSettings, &text, error))
    return false;
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
  SettingStages stages = config.Stages();
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(yaml_text);
    if (documents.size() > 1) {
      *error = PlaceInYaml(place, documents[1].Mark()) + "expected one YAML document, not several";
      return std::nullopt;
    }
    if (!documents.empty() && !ApplyYaml(place, documents[0], &stages, error)) return std::nullopt;
  } catch (const YAML::Exception& exception) {
    *error = PlaceInYaml(place, exception.mark) + "not valid YAML: " + exception.msg;
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
    if (!ReadTextFile(yaml_path, "configuration file", kLargestSettings, &yaml_text, error))
      return std::nullopt;
  }
  return ParseRunConfig(yaml_text, yaml_path, set_text, error);
}

bool ApplySettings(const std::string& set_text, SettingStages stages, std::string* error) {
  return ApplySet(set_text, &stages, error);
}

}  // namespace radive
