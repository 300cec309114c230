// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/choose_representation.h"

#include <cstddef>

#include "radive/ndt/gaussian_builder.h"
#include "radive/util/number_text.h"

namespace radive {
namespace {

constexpr std::size_t kDense = 1000;      // returns
constexpr std::size_t kVeryDense = 4000;  // returns
constexpr double kMinPerVoxel = 2.0;      // returns

}  // namespace

NdtOptions::Representation ChooseRepresentation(const std::vector<RadarReturn>& returns,
                                                const NdtOptions& options,
                                                std::string* reason) {
  std::vector<Eigen::Vector3d> points;
  points.reserve(returns.size());
  for (const RadarReturn& radar_return : returns) points.push_back(radar_return.position);
  NdtOptions all = options;
  all.min_points = 1;
  const std::size_t num_voxels =
      GaussiansOfVoxels(points, std::vector<double>(points.size(), 1.0), all).size();
  const double per_voxel =
      num_voxels == 0 ? 0.0 : static_cast<double>(points.size()) / static_cast<double>(num_voxels);
  const bool is_voxel =
      points.size() >= kVeryDense || (points.size() >= kDense && per_voxel >= kMinPerVoxel);
  *reason = FormatText(
      "ndt.representation %s, for the first scan has %zu static returns, %.1f to a voxel",
      is_voxel ? "voxel" : "point",
      points.size(),
      per_voxel);
  return is_voxel ? NdtOptions::Representation::kVoxel : NdtOptions::Representation::kPoint;
}

}  // namespace radive
