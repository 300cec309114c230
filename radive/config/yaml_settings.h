// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "radive/config/setting_text.h"
#include "radive/util/option_field.h"

// Settings out of YAML blocks, for the files that hold some: configurations and studies.

namespace radive {

// Stages with their fields: ("registration", its fields).
using SettingStages = std::vector<std::pair<std::string, std::vector<OptionField>>>;

// The fields of a stage. Null, with the nearest name or all names in `error`, for an unknown one.
std::vector<OptionField>* FindStage(const std::string& name,
                                    SettingStages* stages,
                                    std::string* error);

// The field STAGE.NAME. Null, with the key that may be meant in `error`, for an unknown one.
OptionField* FindField(const std::string& stage,
                       const std::string& name,
                       SettingStages* stages,
                       std::string* error);

// "FILE:LINE: ", the start of a message.
std::string PlaceInYaml(const std::string& file, const YAML::Mark& mark);

// The text of a value or of a list of values; false for anything else.
bool ToSettingText(const YAML::Node& node, SettingText* text);

// Writes each "key: value" of the map `settings` into the field of that name. False, with the place
// and the reason in `error`, for an unknown or repeated key, a wrong type and a value out of range.
bool ApplyYamlStage(const std::string& file,
                    const std::string& stage,
                    const YAML::Node& settings,
                    SettingStages* stages,
                    std::string* error);

// No file with settings is larger [bytes]; a table or report may be.
inline constexpr std::uintmax_t kLargestSettings = std::uintmax_t{1} << 20;
inline constexpr std::uintmax_t kLargestTable = std::uintmax_t{1} << 30;

// The whole text of a file of at most `max_bytes`; `what` it is stands in the error message.
bool ReadTextFile(const std::string& path,
                  const std::string& what,
                  std::uintmax_t max_bytes,
                  std::string* text,
                  std::string* error);

}  // namespace radive
