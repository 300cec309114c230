// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/registration/point_tree.h"

#include <Eigen/Eigenvalues>
#include <nanoflann.hpp>
#include <utility>

namespace radive {
namespace {

constexpr double kSamePlace = 1e-8;  // variance of points that lie in one place [m^2]
constexpr double kOnALine = 1e-3;    // share of the variance across a line of that along it [-]

}  // namespace

struct PointTree::Tree {
  // The points as nanoflann wants to see them.
  struct Cloud {
    std::vector<Eigen::Vector3d> points;

    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
      return points[i][static_cast<Eigen::Index>(axis)];
    }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };

  using KdTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>,
                                                     Cloud,
                                                     3,
                                                     std::uint32_t>;

  explicit Tree(std::vector<Eigen::Vector3d> points)
      : cloud{std::move(points)}, index(3, cloud, {16}) {}

  Cloud cloud;
  KdTree index;
};

PointTree::PointTree(std::vector<Eigen::Vector3d> points)
    : tree_(std::make_unique<const Tree>(std::move(points))) {}
PointTree::~PointTree() = default;

const std::vector<Eigen::Vector3d>& PointTree::points() const { return tree_->cloud.points; }

std::optional<std::size_t> PointTree::Nearest(const Eigen::Vector3d& position,
                                              double max_distance) const {
  std::uint32_t found = 0;
  double squared_distance = 0.0;
  if (tree_->index.knnSearch(position.data(), 1, &found, &squared_distance) == 0) {
    return std::nullopt;
  }
  if (squared_distance > max_distance * max_distance) return std::nullopt;
  return found;
}

std::vector<std::uint32_t> PointTree::Nearest(const Eigen::Vector3d& position, int count) const {
  std::vector<std::uint32_t> found(static_cast<std::size_t>(count));
  std::vector<double> squared_distances(found.size());
  found.resize(tree_->index.knnSearch(
      position.data(), found.size(), found.data(), squared_distances.data()));
  return found;
}

// Covariance of the nearest points.
Eigen::Matrix3d PointTree::Scatter(const Eigen::Vector3d& position, int count) const {
  const std::vector<std::uint32_t> nearest = Nearest(position, count);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  if (nearest.size() < 3) return scatter;
  const auto size = static_cast<double>(nearest.size());
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::uint32_t i : nearest) mean += points()[i] / size;
  for (const std::uint32_t i : nearest) {
    const Eigen::Vector3d offset = points()[i] - mean;
    scatter += offset * offset.transpose() / size;
  }
  return scatter;
}

std::optional<Eigen::Vector3d> PointTree::Normal(const Eigen::Vector3d& position, int count) const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(Scatter(position, count));
  const Eigen::Vector3d& variances = eigen.eigenvalues();  // ascending
  if (!(variances[2] > kSamePlace && variances[1] > kOnALine * variances[2])) return std::nullopt;
  return eigen.eigenvectors().col(0);
}

std::optional<Eigen::Vector3d> PointTree::NormalAcross(const Eigen::Vector3d& up,
                                                       const Eigen::Vector3d& position,
                                                       int count) const {
  const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity() - up * up.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(flat * Scatter(position, count) *
                                                             flat);
  if (!(eigen.eigenvalues()[2] > kSamePlace)) return std::nullopt;
  // Perpendicular to the line and to `up`.
  const Eigen::Vector3d normal = up.cross(eigen.eigenvectors().col(2));
  return normal.normalized();
}

}  // namespace radive
