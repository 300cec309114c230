// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/config/run_config.h"

namespace radive {

std::vector<std::pair<std::string, std::vector<OptionField>>> RunConfig::Stages() {
  std::vector<std::pair<std::string, std::vector<OptionField>>> stages;
  stages.emplace_back("input", input.Fields());
  for (auto& stage : odometry.Stages()) stages.push_back(std::move(stage));
  stages.emplace_back("output", output.Fields());
  stages.emplace_back("reference", reference.Fields());
  return stages;
}

bool RunConfig::IsValid(std::string* error) const {
  if (!input.IsValid(error) || !odometry.IsValid(error) || !output.IsValid(error) ||
      !reference.IsValid(error)) {
    return false;
  }
  if (output.NeedsSurface() && odometry.submap.type != SubmapOptions::Type::kSdf) {
    *error = "output.map surface and mesh come from the neural submap: they need submap.type sdf";
    return false;
  }
  if (input.radar != "all" || !odometry.sensor.mounts.empty()) return true;
  *error = "input.radar all needs sensor.mounts, which says where each radar sits";
  return false;
}

}  // namespace radive
