// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/config/run_config.h"

#include "radive/util/number_text.h"

namespace radive {

std::vector<std::pair<std::string, std::vector<OptionField>>> RunConfig::Stages() {
  std::vector<std::pair<std::string, std::vector<OptionField>>> stages;
  stages.emplace_back("input", input.Fields());
  for (auto& stage : odometry.Stages()) stages.push_back(std::move(stage));
  stages.emplace_back("output", output.Fields());
  stages.emplace_back("reference", reference.Fields());
  stages.emplace_back("perturbation", perturbation.Fields());
  return stages;
}

bool RunConfig::IsValid(std::string* error) const {
  if (!input.IsValid(error) || !odometry.IsValid(error) || !output.IsValid(error) ||
      !reference.IsValid(error) || !perturbation.IsValid(error)) {
    return false;
  }
  if (output.NeedsSurface() && odometry.submap.type != SubmapOptions::Type::kSdf) {
    *error = "output.map surface and mesh come from the neural submap: they need submap.type sdf";
    return false;
  }
  // The field is sampled around each neural point: at a tenth, 2197 times.
  constexpr double kFinestMesh = 0.1;
  const double resolution = odometry.neural_map.resolution;
  if (output.map == OutputOptions::Map::kMesh &&
      output.mesh_resolution < kFinestMesh * resolution) {
    *error = FormatText(
        "output.mesh_resolution must be >= a tenth of neural_map.resolution (%g m), is %g m",
        resolution,
        output.mesh_resolution);
    return false;
  }
  if (input.radar != "all" || !odometry.sensor.mounts.empty()) return true;
  *error = "input.radar all needs sensor.mounts, which says where each radar sits";
  return false;
}

}  // namespace radive
