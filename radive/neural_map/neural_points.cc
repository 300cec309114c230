// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/neural_points.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "radive/util/cell_key.h"

namespace radive {
namespace {

// Puts (index, squared distance) into its place among the nearest `limit`.
void Insert(int index, double squared_distance, int limit, Neighbors* neighbors) {
  int at = neighbors->count;
  const auto is_behind = [&](std::size_t other) {
    const double d = neighbors->squared_distance[other];
    return d > squared_distance || (d == squared_distance && neighbors->index[other] > index);
  };
  if (at == limit) {
    if (!is_behind(static_cast<std::size_t>(at - 1))) return;
    --at;
  } else {
    ++neighbors->count;
  }
  for (; at > 0 && is_behind(static_cast<std::size_t>(at - 1)); --at) {
    const std::size_t to = static_cast<std::size_t>(at);
    neighbors->index[to] = neighbors->index[to - 1];
    neighbors->squared_distance[to] = neighbors->squared_distance[to - 1];
  }
  neighbors->index[static_cast<std::size_t>(at)] = index;
  neighbors->squared_distance[static_cast<std::size_t>(at)] = squared_distance;
}

}  // namespace

NeuralPoints::NeuralPoints(const NeuralMapOptions& options)
    : options_(options), inverse_resolution_(1.0 / options.resolution) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
}

std::vector<int> NeuralPoints::AddKeyframe(const std::vector<MapReturn>& returns,
                                           int index,
                                           const Eigen::Vector3d& origin) {
  const double squared_scale = options_.noise_scale * options_.noise_scale;
  last_keyframe_ = index;
  ++version_;
  std::vector<int> seen;
  for (const MapReturn& entry : returns) {
    if (!entry.position.allFinite()) continue;
    const double weight = entry.weight * squared_scale / (squared_scale + entry.covariance.trace());
    if (!(weight > 0.0)) continue;
    const Eigen::Array3d cell = CellOf(entry.position);
    const std::uint64_t key = CellKey(cell.x(), cell.y(), cell.z());
    int k = InCell(cell);
    const bool is_new = k < 0;
    if (is_new) {
      k = size();
      SetInCell(CellOfKey(key), k);
      points_.emplace_back();
      points_.back().position = entry.position;
      points_.back().cell = key;
      points_.back().created = index;
      points_.back().last_update = index;
      features_.resize(features_.size() + static_cast<std::size_t>(options_.feature_dim), 0.0);
      seen.push_back(k);
    }
    NeuralPoint& point = points_[static_cast<std::size_t>(k)];
    if (!is_new && point.last_update != index) {
      CHECK_GT(index, point.last_update);
      point.last_update = index;
      point.keyframe_weight = 0.0;
      seen.push_back(k);
    }
    if (weight > point.keyframe_weight) {
      point.certainty += weight - point.keyframe_weight;
      point.keyframe_weight = weight;
    }
    point.weight_sum += weight;
    const double gain = weight / point.weight_sum;
    point.covariance += gain * (entry.covariance - point.covariance);
    point.to_radar += gain * ((origin - entry.position).normalized() - point.to_radar);
    if (options_.position == NeuralMapOptions::Position::kMean) {
      point.position += gain * (entry.position - point.position);
    }
  }
  std::sort(seen.begin(), seen.end());
  for (const int k : seen) MarkChangedAround(k);
  return seen;
}

void NeuralPoints::Prune(const Eigen::Vector3d& center, int index) {
  const double max_squared_distance = options_.max_distance * options_.max_distance;
  const std::size_t dim = static_cast<std::size_t>(options_.feature_dim);
  ++version_;
  std::vector<bool> goes(points_.size());
  for (std::size_t k = 0; k < points_.size(); ++k) {
    goes[k] = index - points_[k].last_update > options_.max_age ||
              (points_[k].position - center).squaredNorm() > max_squared_distance;
    if (goes[k]) MarkChangedAround(static_cast<int>(k));
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    if (goes[k]) continue;
    if (kept != k) {
      points_[kept] = points_[k];
      std::copy_n(&features_[k * dim], dim, &features_[kept * dim]);
    }
    ++kept;
  }
  if (kept == points_.size()) return;
  points_.resize(kept);
  features_.resize(kept * dim);
  Rebuild();
}

void NeuralPoints::Clear() {
  last_keyframe_ = -1;
  points_.clear();
  features_.clear();
  cells_.Clear();
}

void NeuralPoints::Transform(const Rigid3& T_new_old) {
  ++version_;
  const Eigen::Matrix3d R = T_new_old.RotationMatrix();
  for (NeuralPoint& point : points_) {
    point.position = T_new_old * point.position;
    point.orientation = (point.orientation * T_new_old.rotation.conjugate()).normalized();
    point.covariance = R * point.covariance * R.transpose();
    point.to_radar = R * point.to_radar;
    const Eigen::Array3d cell = CellOf(point.position);
    point.cell = CellKey(cell.x(), cell.y(), cell.z());
    point.last_change = version_;
  }
  Rebuild();
}

void NeuralPoints::Rebuild() {
  cells_.Clear();
  for (int k = size() - 1; k >= 0; --k) {
    const Eigen::Vector3i cell = CellOfKey(point(k).cell);
    point(k).next = InCell(cell.cast<double>().array());
    SetInCell(cell, k);
  }
}

int NeuralPoints::InCell(const Eigen::Array3d& cell) const {
  // By way of the key: cells that it does not tell apart are one.
  const Eigen::Vector3i at = CellOfKey(CellKey(cell.x(), cell.y(), cell.z()));
  return cells_.Find(at.x(), at.y(), at.z());
}

void NeuralPoints::SetInCell(const Eigen::Vector3i& cell, int k) {
  cells_.Set(cell.x(), cell.y(), cell.z(), k);
}

// Of all that a point of this cell can be within twice the resolution of.
void NeuralPoints::MarkChangedAround(int k) {
  const Eigen::Vector3i cell = CellOfKey(point(k).cell);
  cells_.ForEachAround(cell.x(), cell.y(), cell.z(), [&](int other) {
    for (; other >= 0; other = point(other).next) point(other).last_change = version_;
  });
}

void NeuralPoints::FindNear(const Eigen::Vector3d& position, std::vector<NearPoint>* near) const {
  near->clear();
  if (!position.allFinite()) return;
  const Eigen::Array3d cell = CellOf(position);
  const double max_squared_distance = 4.0 * options_.resolution * options_.resolution;
  cells_.ForEachAround(static_cast<std::int64_t>(cell.x()),
                       static_cast<std::int64_t>(cell.y()),
                       static_cast<std::int64_t>(cell.z()),
                       [&](int k) {
                         for (; k >= 0; k = point(k).next) {
                           const double squared = (point(k).position - position).squaredNorm();
                           if (squared <= max_squared_distance) near->push_back({k, squared});
                         }
                       });
}

Neighbors NeuralPoints::Nearest(const std::vector<NearPoint>& near, int except) const {
  Neighbors neighbors;
  for (const NearPoint& entry : near) {
    if (entry.index == except) continue;
    Insert(entry.index, entry.squared_distance, options_.num_neighbors, &neighbors);
  }
  return neighbors;
}

Neighbors NeuralPoints::Nearest(const Eigen::Vector3d& position, int except) const {
  std::vector<NearPoint> near;
  FindNear(position, &near);
  return Nearest(near, except);
}

double NeuralPoints::Support(const std::vector<NearPoint>& near) const {
  const double inverse = 0.5 * inverse_resolution_ * inverse_resolution_;
  double support = 0.0;
  for (const NearPoint& entry : near) {
    support +=
        std::sqrt(point(entry.index).certainty) * std::exp(-inverse * entry.squared_distance);
  }
  return support;
}

double NeuralPoints::Support(const Eigen::Vector3d& position) const {
  std::vector<NearPoint> near;
  FindNear(position, &near);
  return Support(near);
}

int NeuralPoints::At(const Eigen::Vector3d& position) const { return InCell(CellOf(position)); }

}  // namespace radive
