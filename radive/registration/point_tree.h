// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace radive {

// Nearest neighbours among fixed points, and the shape of the surface that they sample.
class PointTree {
 public:
  explicit PointTree(std::vector<Eigen::Vector3d> points);  // finite ones [m]
  ~PointTree();

  // Index of the point nearest to `position`; nothing when it is further than `max_distance` [m].
  std::optional<std::size_t> Nearest(const Eigen::Vector3d& position, double max_distance) const;

  // Indices of the `count` nearest points, fewer when there are fewer; nearest first.
  std::vector<std::uint32_t> Nearest(const Eigen::Vector3d& position, int count) const;

  // Unit normal of the plane through the `count` nearest points of `position`. Nothing when there
  // are fewer than three, or when they lie on a line or in one place.
  std::optional<Eigen::Vector3d> Normal(const Eigen::Vector3d& position, int count) const;

  // The same for points without height: of the line that their projections along the unit vector
  // `up` make. Two places are enough.
  std::optional<Eigen::Vector3d> NormalAcross(const Eigen::Vector3d& up,
                                              const Eigen::Vector3d& position,
                                              int count) const;

  const std::vector<Eigen::Vector3d>& points() const;

 private:
  struct Tree;
  Eigen::Matrix3d Scatter(const Eigen::Vector3d& position, int count) const;

  std::unique_ptr<const Tree> tree_;
};

}  // namespace radive
