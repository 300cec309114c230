// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/gaussian_builder.h"

#include <glog/logging.h>
#include <tsl/robin_map.h>

#include <cmath>
#include <cstdint>

#include "radive/sensor/radar_noise_model.h"
#include "radive/util/cell_key.h"

namespace radive {
namespace {

// std::floor() is a function call for processors without SSE 4.1.
std::int64_t WholePart(double value) {
  const auto towards_zero = static_cast<std::int64_t>(value);
  return towards_zero - (value < static_cast<double>(towards_zero) ? 1 : 0);
}

}  // namespace

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
  struct Sums {
    Eigen::Vector3d first;  // sums are taken relative to it: no cancellation far from the origin
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;  // of outer products
    double weight = 0.0;
    int count = 0;
  };
  std::vector<Sums> voxels;
  tsl::robin_map<std::uint64_t, std::uint32_t, CellKeyHash> index;
  index.reserve(points.size() / 2);
  const Eigen::Array3d inverse_size(
      1.0 / options.voxel_size[0], 1.0 / options.voxel_size[1], 1.0 / options.voxel_size[2]);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Array3d cell = points[i].array() * inverse_size;
    const std::uint64_t key =
        CellKey(WholePart(cell.x()), WholePart(cell.y()), WholePart(cell.z()));
    const auto [entry, is_new] = index.try_emplace(key, voxels.size());
    if (is_new) {
      voxels.emplace_back();
      voxels.back().first = points[i];
    }
    Sums& voxel = voxels[entry.value()];
    const Eigen::Vector3d p = points[i] - voxel.first;
    voxel.sum += p;
    voxel.xx += p.x() * p.x();
    voxel.xy += p.x() * p.y();
    voxel.xz += p.x() * p.z();
    voxel.yy += p.y() * p.y();
    voxel.yz += p.y() * p.z();
    voxel.zz += p.z() * p.z();
    voxel.weight += weights[i];
    ++voxel.count;
  }

  std::vector<Gaussian3> gaussians;
  gaussians.reserve(voxels.size());
  for (const Sums& voxel : voxels) {
    if (voxel.count < options.min_points) continue;
    const double n = voxel.count;
    const Eigen::Vector3d mean = voxel.sum / n;
    Gaussian3 gaussian;
    gaussian.mean = voxel.first + mean;
    Eigen::Matrix3d outer;
    outer << voxel.xx, voxel.xy, voxel.xz, voxel.xy, voxel.yy, voxel.yz, voxel.xz, voxel.yz,
        voxel.zz;
    gaussian.covariance = outer / n - mean * mean.transpose();
    gaussian.covariance.diagonal().array() += options.epsilon;
    gaussian.weight = voxel.weight / n;
    gaussian.count = voxel.count;
    gaussians.push_back(gaussian);
  }
  return gaussians;
}

}  // namespace radive
