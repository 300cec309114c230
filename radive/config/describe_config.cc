// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/config/describe_config.h"

namespace radive {

std::string DescribeConfig() {
  RunConfig defaults;
  std::string text =
      "# Settings and their defaults. A file for --config holds those that differ, in this form;\n"
      "# --set stage.field=value,... wins over the file.\n";
  for (const auto& [stage, fields] : defaults.Stages()) {
    text += "\n" + stage + ":\n";
    for (const OptionField& field : fields) {
      const std::string unit =
          field.unit.empty() || field.unit == "-" ? "" : " [" + field.unit + "]";
      const std::string rule = field.Rule().empty() ? "" : " (" + field.Rule() + ")";
      text += "  # " + field.doc + unit + rule + "\n";
      text += "  " + field.name + ": " + field.ToString() + "\n";
    }
  }
  return text;
}

std::string EffectiveConfig(const RunConfig& config) {
  RunConfig copy = config;
  std::string text;
  for (const auto& [stage, fields] : copy.Stages()) {
    if (fields.empty()) continue;
    text += stage + ":\n";
    for (const OptionField& field : fields) {
      text += "  " + field.name + ": " + field.ToString() + "\n";
    }
  }
  return text;
}

}  // namespace radive
