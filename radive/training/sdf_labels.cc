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
constexpr double kMinSmoothWidth = 0.2;  // of the neural points of a smooth plane, in kernels

// Weighted moments of points about a position, and the plane through them.
class PlaneSums {
 public:
  // Sums are taken relative to `origin`: no cancellation far from that of the map.
  explicit PlaneSums(const Eigen::Vector3d& origin) : origin_(origin) {}

  // `trust`: what the point adds to the mean weight of the plane.
  void Add(const Eigen::Vector3d& position,
           double weight,
           double trust,
           const Eigen::Vector3d& to_radar) {
    const Eigen::Vector3d p = position - origin_;
    sum_ += weight * p;
    outer_ += weight * p * p.transpose();
    to_radar_ += weight * to_radar;
    weight_ += weight;
    trust_ += trust;
    ++count_;
  }

  // Nothing where the points are fewer than three or nearly in a line, with a standard deviation
  // below `min_width` [m] across it: then any plane through the line would do. Points of a planar
  // sensor give an upright plane through their line in x and y.
  std::optional<LocalPlane> Plane(double min_width, bool is_planar) const {
    if (count_ < 3 || !(weight_ > 0.0)) return std::nullopt;
    const Eigen::Vector3d mean = sum_ / weight_;
    const Eigen::Matrix3d S = outer_ / weight_ - mean * mean.transpose();
    const double min_variance = min_width * min_width;
    LocalPlane plane;
    plane.point = origin_ + mean;
    plane.weight = trust_ / count_;
    if (is_planar) {
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
      axes.computeDirect(Eigen::Matrix2d(S.topLeftCorner<2, 2>()));
      if (axes.eigenvalues()[1] < min_variance) return std::nullopt;
      plane.normal << axes.eigenvectors().col(0), 0.0;
    } else {
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
      axes.computeDirect(S);
      if (axes.eigenvalues()[1] < min_variance) return std::nullopt;
      plane.normal = axes.eigenvectors().col(0);
    }
    if (plane.normal.dot(to_radar_) < 0.0) plane.normal = -plane.normal;
    if (!plane.normal.allFinite()) return std::nullopt;
    return plane;
  }

 private:
  const Eigen::Vector3d origin_;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d outer_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d to_radar_ = Eigen::Vector3d::Zero();
  double weight_ = 0.0;
  double trust_ = 0.0;
  int count_ = 0;
};

}  // namespace

struct SdfLabels::Tree {
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

  using KdTree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>,
                                                     Cloud,
                                                     3,
                                                     std::uint32_t>;

  static Cloud MakeCloud(const std::vector<const LabelScan*>& window) {
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

SdfLabels::SdfLabels(const std::vector<const LabelScan*>& window,
                     const NeuralPoints& map,
                     const SdfTrainingOptions& options,
                     bool is_planar)
    : map_(map), options_(options), is_planar_(is_planar) {
  if (IsSmooth()) return;
  Tree::Cloud cloud = Tree::MakeCloud(window);
  if (!cloud.points.empty()) tree_ = std::make_unique<Tree>(std::move(cloud));
}

SdfLabels::~SdfLabels() = default;

int SdfLabels::num_points() const {
  return tree_ == nullptr ? 0 : static_cast<int>(tree_->cloud.points.size());
}

std::optional<LocalPlane> SdfLabels::PlaneAt(const Eigen::Vector3d& position,
                                             const std::vector<NearPoint>& near) const {
  if (!position.allFinite()) return std::nullopt;
  return IsSmooth() ? SmoothPlane(position, near) : NearestPlane(position);
}

std::optional<LocalPlane> SdfLabels::NearestPlane(const Eigen::Vector3d& position) const {
  if (tree_ == nullptr) return std::nullopt;
  std::array<std::uint32_t, kMaxLabelPoints> found;
  std::array<double, kMaxLabelPoints> squared_distance;
  const std::size_t count =
      tree_->Nearest(position, options_.label_points, &found, &squared_distance);
  PlaneSums sums(position);
  for (std::size_t i = 0; i < count; ++i) {
    const Tree::Cloud::Point& point = tree_->cloud.points[found[i]];
    sums.Add(point.position,
             point.weight,
             point.weight,
             (tree_->cloud.origins[point.scan] - point.position).normalized());
  }
  return sums.Plane(0.0, is_planar_);
}

std::optional<LocalPlane> SdfLabels::SmoothPlane(const Eigen::Vector3d& position,
                                                 const std::vector<NearPoint>& near) const {
  const double inverse = 0.5 / (options_.label_kernel * options_.label_kernel);
  PlaneSums sums(position);
  for (const NearPoint& entry : near) {
    const NeuralPoint& point = map_.point(entry.index);
    const double weight = point.weight_sum * std::exp(-inverse * entry.squared_distance);
    sums.Add(point.position, weight, 1.0, point.to_radar);
  }
  return sums.Plane(kMinSmoothWidth * options_.label_kernel, is_planar_);
}

std::optional<SdfLabel> SdfLabels::At(const Eigen::Vector3d& position,
                                      const std::vector<NearPoint>& near) const {
  SdfLabel label;
  if (options_.label == SdfTrainingOptions::Label::kPlane || IsSmooth()) {
    const std::optional<LocalPlane> plane = PlaneAt(position, near);
    if (!plane) return std::nullopt;
    label.distance = plane->normal.dot(position - plane->point);
    label.weight = plane->weight;
  } else {
    if (tree_ == nullptr || !position.allFinite()) return std::nullopt;
    std::array<std::uint32_t, kMaxLabelPoints> found;
    std::array<double, kMaxLabelPoints> squared_distance;
    tree_->Nearest(position, 1, &found, &squared_distance);
    const Tree::Cloud::Point& nearest = tree_->cloud.points[found[0]];
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

std::optional<SdfLabel> SdfLabels::At(const Eigen::Vector3d& position) const {
  std::vector<NearPoint> near;
  map_.FindNear(position, &near);
  return At(position, near);
}

}  // namespace radive
