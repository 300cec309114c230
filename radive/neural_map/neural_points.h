// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <vector>

#include "radive/geometry/rigid3.h"
#include "radive/neural_map/cell_blocks.h"
#include "radive/neural_map/neural_map_options.h"

namespace radive {

// A neural point, but for its feature.
struct NeuralPoint {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();               // map frame [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  // q_k: from map axes to its own

  // Sum over the keyframes that saw it of the largest weight of their returns in its cell [-].
  double certainty = 0.0;
  int created = 0;      // index of the first keyframe that saw it
  int last_update = 0;  // ... and of the last

  // NeuralPoints::version() since which nothing is different within twice the resolution.
  std::uint64_t last_change = 0;

  // The returns in its cell: sum of weights [-], their mean measurement covariance [m^2], and the
  // mean direction from them to the radar, not of unit length [-].
  double weight_sum = 0.0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Eigen::Vector3d to_radar = Eigen::Vector3d::Zero();

  std::uint64_t cell = 0;        // key of its cell
  double keyframe_weight = 0.0;  // largest weight in the last keyframe
  int next = -1;                 // another point of the same cell, which only Transform() makes
};

// A return as the map takes it in.
struct MapReturn {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();    // map frame [m]
  double weight = 1.0;                                   // velocity-discrepancy weight [-], > 0
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // of the measurement, map frame [m^2]
};

struct NearPoint {
  int index = 0;
  double squared_distance = 0.0;  // [m^2]
};

// The K nearest neural points of a position.
struct Neighbors {
  int count = 0;
  std::array<int, kMaxSdfNeighbors> index{};                // ascending distance, then index
  std::array<double, kMaxSdfNeighbors> squared_distance{};  // [m^2]
};

// The neural points of a map, in a voxel hash: one a cell.
class NeuralPoints {
 public:
  // `options` must be valid.
  explicit NeuralPoints(const NeuralMapOptions& options);

  // Takes in the returns of keyframe `index` (must not decrease), measured from `origin` [m]. Cells
  // that had no point get one, with a feature of all zeros. A return counts with its weight times
  // s^2 / (s^2 + trace of its covariance), s the option `noise_scale`. Returns that are not finite
  // or have no positive weight are left out. Returns the points that were seen, ascending.
  std::vector<int> AddKeyframe(const std::vector<MapReturn>& returns,
                               int index,
                               const Eigen::Vector3d& origin = Eigen::Vector3d::Zero());

  // Forgets points that are too old or too far from `center` [m]; indices change.
  void Prune(const Eigen::Vector3d& center, int index);

  void Clear();

  // Moves all points: p -> T p; features keep their meaning (relative vectors turn back through
  // the orientations).
  void Transform(const Rigid3& T_new_old);

  // The points within twice the resolution of a position.
  void FindNear(const Eigen::Vector3d& position, std::vector<NearPoint>* near) const;

  // The K nearest points of those, without the point `except`.
  Neighbors Nearest(const std::vector<NearPoint>& near, int except = -1) const;
  Neighbors Nearest(const Eigen::Vector3d& position, int except = -1) const;

  // How much the map trusts that something is there: sum of sqrt(c_k) exp(-d_k^2 / (2 res^2)) over
  // the points within twice the resolution. The root makes a surface out of many points worth more
  // than one cell that many keyframes hit, such as a ghost that stands still. At a lone point that
  // one keyframe saw at most 1 [-].
  double Support(const std::vector<NearPoint>& near) const;
  double Support(const Eigen::Vector3d& position) const;

  // Grows with each change of the points. Their features count as changed in the keyframes that see
  // them.
  std::uint64_t version() const { return version_; }

  int last_keyframe() const { return last_keyframe_; }  // its index; -1 before the first

  // The point whose cell holds `position`; -1: none.
  int At(const Eigen::Vector3d& position) const;

  int size() const { return static_cast<int>(points_.size()); }
  const std::vector<NeuralPoint>& points() const { return points_; }
  NeuralPoint& point(int k) { return points_[static_cast<std::size_t>(k)]; }
  const NeuralPoint& point(int k) const { return points_[static_cast<std::size_t>(k)]; }
  const double* feature(int k) const { return &features_[FeatureIndex(k)]; }
  // Stays valid until points are added or pruned.
  double* feature(int k) { return &features_[FeatureIndex(k)]; }

  // d_jk = q_k (x_j - x_k) q_k^-1: `position` relative to point k, in its axes [m].
  Eigen::Vector3d Relative(int k, const Eigen::Vector3d& position) const {
    const NeuralPoint& at = point(k);
    return at.orientation * (position - at.position);
  }

  const NeuralMapOptions& options() const { return options_; }

 private:
  std::size_t FeatureIndex(int k) const {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(options_.feature_dim);
  }
  Eigen::Array3d CellOf(const Eigen::Vector3d& position) const {
    return (position.array() * inverse_resolution_).floor();
  }
  // The point of a cell; -1: none.
  int InCell(const Eigen::Array3d& cell) const;
  void SetInCell(const Eigen::Vector3i& cell, int k);
  void MarkChangedAround(int k);
  void Rebuild();

  const NeuralMapOptions options_;
  const double inverse_resolution_;
  int last_keyframe_ = -1;
  std::uint64_t version_ = 0;
  std::vector<NeuralPoint> points_;
  std::vector<double> features_;
  CellBlocks cells_;  // the first point of each
};

}  // namespace radive
