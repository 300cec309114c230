// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/training/sdf_labels.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nanoflann.hpp>

namespace radive {
namespace {

constexpr std::size_t kMaxLabelPoints = 64;

// The points as nanoflann wants to see them.
struct Cloud {
  struct Point {
    Eigen::Vector3d position;
    double weight;
    std::uint32_t scan;
  };
  std::vector<Point> points;
  std::vector<Eigen::Vector3d> origins;  // one a scan

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return points[i].position[static_cast<Eigen::Index>(axis)];
  }
  template <typename Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using KdTree = nanoflann::
    KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3, std::uint32_t>;

Cloud MakeCloud(const std::vector<const LabelScan*>& window) {
  Cloud cloud;
  for (const LabelScan* scan : window) {
    const std::uint32_t index = static_cast<std::uint32_t>(cloud.origins.size());
    cloud.origins.push_back(scan->origin);
    for (std::size_t i = 0; i < scan->points.size(); ++i) {
      if (!scan->points[i].allFinite() || !(scan->weights[i] > 0.0)) continue;
      cloud.points.push_back({scan->points[i], scan->weights[i], index});
    }
  }
  return cloud;
}

}  // namespace

struct SdfLabels::Tree {
  explicit Tree(Cloud points) : cloud(std::move(points)), index(3, cloud, {16}) {}

  std::size_t Nearest(const Eigen::Vector3d& position,
                      int count,
                      std::array<std::uint32_t, kMaxLabelPoints>* found,
                      std::array<double, kMaxLabelPoints>* squared_distance) const {
    return index.knnSearch(
        position.data(), static_cast<std::size_t>(count), found->data(), squared_distance->data());
  }

  const Cloud cloud;
  const KdTree index;
};

SdfLabels::SdfLabels(const std::vector<const LabelScan*>& window, const SdfTrainingOptions& options)
    : options_(options) {
  Cloud cloud = MakeCloud(window);
  if (!cloud.points.empty()) tree_ = std::make_unique<Tree>(std::move(cloud));
}

SdfLabels::~SdfLabels() = default;

int SdfLabels::num_points() const {
  return tree_ == nullptr ? 0 : static_cast<int>(tree_->cloud.points.size());
}

std::optional<LocalPlane> SdfLabels::PlaneAt(const Eigen::Vector3d& position) const {
  if (tree_ == nullptr || !position.allFinite()) return std::nullopt;
  std::array<std::uint32_t, kMaxLabelPoints> found;
  std::array<double, kMaxLabelPoints> squared_distance;
  const std::size_t count =
      tree_->Nearest(position, options_.label_points, &found, &squared_distance);
  if (count < 3) return std::nullopt;

  // Sums relative to `position`: no cancellation far from the origin.
  double weight_sum = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d outer = Eigen::Matrix3d::Zero();
  Eigen::Vector3d to_radar = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    const Cloud::Point& point = tree_->cloud.points[found[i]];
    const Eigen::Vector3d p = point.position - position;
    mean += point.weight * p;
    outer += point.weight * p * p.transpose();
    weight_sum += point.weight;
    to_radar += point.weight * (tree_->cloud.origins[point.scan] - point.position).normalized();
  }
  mean /= weight_sum;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(Eigen::Matrix3d(outer / weight_sum - mean * mean.transpose()));
  LocalPlane plane;
  plane.point = position + mean;
  plane.normal = axes.eigenvectors().col(0);
  plane.weight = weight_sum / static_cast<double>(count);
  if (plane.normal.dot(to_radar) < 0.0) plane.normal = -plane.normal;
  if (!plane.normal.allFinite()) return std::nullopt;
  return plane;
}

std::optional<SdfLabel> SdfLabels::At(const Eigen::Vector3d& position) const {
  if (tree_ == nullptr || !position.allFinite()) return std::nullopt;
  SdfLabel label;
  if (options_.label == SdfTrainingOptions::Label::kPlane) {
    const std::optional<LocalPlane> plane = PlaneAt(position);
    if (!plane) return std::nullopt;
    label.distance = plane->normal.dot(position - plane->point);
    label.weight = plane->weight;
  } else {
    std::array<std::uint32_t, kMaxLabelPoints> found;
    std::array<double, kMaxLabelPoints> squared_distance;
    tree_->Nearest(position, 1, &found, &squared_distance);
    const Cloud::Point& nearest = tree_->cloud.points[found[0]];
    label.weight = nearest.weight;
    if (options_.label == SdfTrainingOptions::Label::kUnsigned) {
      label.distance = std::sqrt(squared_distance[0]);
    } else {
      const Eigen::Vector3d to_radar =
          (tree_->cloud.origins[nearest.scan] - nearest.position).normalized();
      label.distance = to_radar.dot(position - nearest.position);
    }
  }
  label.distance = std::clamp(label.distance, -options_.label_clamp, options_.label_clamp);
  return label;
}

}  // namespace radive
