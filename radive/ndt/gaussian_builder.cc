// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/gaussian_builder.h"

#include <glog/logging.h>
#include <tsl/robin_map.h>

#include <cstdint>

#include "radive/ndt/voxel_sums.h"
#include "radive/sensor/radar_noise_model.h"
#include "radive/util/cell_key.h"

namespace radive {
std::vector<Gaussian3> GaussiansOfReturns(const std::vector<RadarReturn>& returns,
                                          const std::vector<double>& weights,
                                          const SensorOptions& sensor,
                                          const NdtOptions& options,
                                          bool is_planar) {
  CHECK_EQ(returns.size(), weights.size());
  std::vector<Gaussian3> gaussians;
  gaussians.reserve(returns.size());
  for (std::size_t i = 0; i < returns.size(); ++i) {
    Gaussian3 gaussian;
    gaussian.mean = returns[i].position;
    gaussian.covariance = PositionCovariance(returns[i].position, sensor, is_planar);
    gaussian.covariance.diagonal().array() += options.epsilon;
    gaussian.weight = weights[i];
    gaussians.push_back(gaussian);
  }
  return gaussians;
}

std::vector<Gaussian3> GaussiansOfVoxels(const std::vector<Eigen::Vector3d>& points,
                                         const std::vector<double>& weights,
                                         const NdtOptions& options) {
  CHECK_EQ(points.size(), weights.size());
  struct Voxel {
    Eigen::Vector3d place;  // its first point
    VoxelSums sums;
  };
  std::vector<Voxel> voxels;
  tsl::robin_map<std::uint64_t, std::uint32_t, CellKeyHash> index;
  index.reserve(points.size() / 2);
  const VoxelGrid grid({options.voxel_size[0], options.voxel_size[1], options.voxel_size[2]});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto [entry, is_new] = index.try_emplace(grid.Key(points[i]), voxels.size());
    if (is_new) voxels.push_back({points[i], VoxelSums()});
    Voxel& voxel = voxels[entry.value()];
    voxel.sums.Add(points[i] - voxel.place, weights[i]);
  }

  std::vector<Gaussian3> gaussians;
  gaussians.reserve(voxels.size());
  for (const Voxel& voxel : voxels) {
    if (voxel.sums.count < options.min_points) continue;
    gaussians.push_back(voxel.sums.Gaussian(voxel.place, options.epsilon));
  }
  return gaussians;
}

}  // namespace radive
