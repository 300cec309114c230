// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/preprocessing/field_of_view_filter.h"

#include "radive/geometry/spherical.h"

namespace radive {

bool InFieldOfView(const Eigen::Vector3d& p_radar, const PreprocessingOptions& options) {
  if (!p_radar.allFinite()) return false;
  const Spherical s = ToSpherical(p_radar);
  return s.range >= options.min_range && s.range <= options.max_range &&
         s.azimuth >= options.min_azimuth && s.azimuth <= options.max_azimuth &&
         s.elevation >= options.min_elevation && s.elevation <= options.max_elevation;
}

bool InRange(const Eigen::Vector3d& p_radar, const PreprocessingOptions& options) {
  const double range = ToSpherical(p_radar).range;
  return range >= options.min_range && range <= options.max_range;
}

std::vector<RadarReturn> GateFieldOfView(const std::vector<RadarReturn>& returns,
                                         const PreprocessingOptions& options) {
  std::vector<RadarReturn> kept;
  kept.reserve(returns.size());
  for (const RadarReturn& entry : returns) {
    if (InFieldOfView(entry.position, options)) kept.push_back(entry);
  }
  return kept;
}

}  // namespace radive
