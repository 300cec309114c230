// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "radive/geometry/gaussian3.h"
#include "radive/util/cell_key.h"

namespace radive {

// Sums over the points of a voxel, relative to a place in it [m]: no cancellation far from the
// origin.
struct VoxelSums {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;  // of outer products
  double weight = 0.0;
  int count = 0;

  void Add(const Eigen::Vector3d& p, double point_weight) {
    sum += p;
    xx += p.x() * p.x();
    xy += p.x() * p.y();
    xz += p.x() * p.z();
    yy += p.y() * p.y();
    yz += p.y() * p.z();
    zz += p.z() * p.z();
    weight += point_weight;
    ++count;
  }

  // `sign`: 1 to add those of other points, -1 to take them away.
  void Add(const VoxelSums& other, int sign) {
    sum += sign * other.sum;
    xx += sign * other.xx;
    xy += sign * other.xy;
    xz += sign * other.xz;
    yy += sign * other.yy;
    yz += sign * other.yz;
    zz += sign * other.zz;
    weight += sign * other.weight;
    count += sign * other.count;
  }

  // Of at least one point. `place`: what the sums are relative to.
  Gaussian3 Gaussian(const Eigen::Vector3d& place, double epsilon) const {
    const double n = count;
    const Eigen::Vector3d mean = sum / n;
    Gaussian3 gaussian;
    gaussian.mean = place + mean;
    Eigen::Matrix3d outer;
    outer << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    gaussian.covariance = outer / n - mean * mean.transpose();
    gaussian.covariance.diagonal().array() += epsilon;
    gaussian.weight = weight / n;
    gaussian.count = count;
    return gaussian;
  }
};

// A grid of voxels from the origin of a frame.
class VoxelGrid {
 public:
  explicit VoxelGrid(const Eigen::Array3d& size) : inverse_size_(size.inverse()) {}

  std::uint64_t Key(const Eigen::Vector3d& point) const {
    const Eigen::Array3d cell = point.array() * inverse_size_;
    return CellKey(WholePart(cell.x()), WholePart(cell.y()), WholePart(cell.z()));
  }

 private:
  // std::floor() is a function call for processors without SSE 4.1.
  static std::int64_t WholePart(double value) {
    const auto towards_zero = static_cast<std::int64_t>(value);
    return towards_zero - (value < static_cast<double>(towards_zero) ? 1 : 0);
  }

  Eigen::Array3d inverse_size_;
};

}  // namespace radive
