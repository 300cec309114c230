// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "radive/config/run_config.h"
#include "radive/util/option_field.h"

namespace radive {

// The configuration of a run: the defaults, changed by the YAML file `yaml_path` (none when
// empty), changed by `set_text`, where later settings win.
//
//   yaml:  registration:            set_text:  registration.d_max=5,input.offset=[1,2,3]
//            d_max: 10
//
// An unknown or repeated key, a value of the wrong type or out of range is an error that names
// the place, the key, the value and the rule, and suggests the nearest key. input.radar=all makes
// motion.body the vehicle: no radar of several is the one that the trajectory would be of.
std::optional<RunConfig> LoadRunConfig(const std::string& yaml_path,
                                       const std::string& set_text,
                                       std::string* error);

// The same with the YAML text itself; `place` stands for the file name in messages.
std::optional<RunConfig> ParseRunConfig(const std::string& yaml_text,
                                        const std::string& place,
                                        const std::string& set_text,
                                        std::string* error);

// Applies `set_text` to stages of any program, each a name and its fields; errors as above. Bounds
// of single fields are checked, IsValid() is left to the caller.
bool ApplySettings(const std::string& set_text,
                   std::vector<std::pair<std::string, std::vector<OptionField>>> stages,
                   std::string* error);

}  // namespace radive
