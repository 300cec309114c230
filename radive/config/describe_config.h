// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "radive/config/run_config.h"

namespace radive {

// Every setting with its default, unit, rule and meaning, for --help_config.
std::string DescribeConfig();

// All settings of `config` as YAML text that LoadRunConfig reads back to the same configuration.
std::string EffectiveConfig(const RunConfig& config);

}  // namespace radive
