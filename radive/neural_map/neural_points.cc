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
  std::vector<int> seen;
  for (const MapReturn& entry : returns) {
    if (!entry.position.allFinite()) continue;
    const double weight = entry.weight * squared_scale / (squared_scale + entry.covariance.trace());
    if (!(weight > 0.0)) continue;
    const Eigen::Array3d cell = CellOf(entry.position);
    const std::uint64_t key = CellKey(cell.x(), cell.y(), cell.z());
    const auto [at, is_new] = cells_.try_emplace(key, static_cast<std::int32_t>(points_.size()));
    if (is_new) {
      occupied_.Insert(static_cast<std::int64_t>(cell.x()),
                       static_cast<std::int64_t>(cell.y()),
                       static_cast<std::int64_t>(cell.z()));
      points_.emplace_back();
      points_.back().position = entry.position;
      points_.back().cell = key;
      points_.back().created = index;
      points_.back().last_update = index;
      features_.resize(features_.size() + static_cast<std::size_t>(options_.feature_dim), 0.0);
      seen.push_back(at->second);
    }
    NeuralPoint& point = points_[static_cast<std::size_t>(at->second)];
    if (!is_new && point.last_update != index) {
      CHECK_GT(index, point.last_update);
      point.last_update = index;
      point.keyframe_weight = 0.0;
      seen.push_back(at->second);
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
  return seen;
}

void NeuralPoints::Prune(const Eigen::Vector3d& center, int index) {
  const double max_squared_distance = options_.max_distance * options_.max_distance;
  const std::size_t dim = static_cast<std::size_t>(options_.feature_dim);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const NeuralPoint& point = points_[k];
    if (index - point.last_update > options_.max_age ||
        (point.position - center).squaredNorm() > max_squared_distance) {
      continue;
    }
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
  cells_.clear();
  occupied_.Clear();
}

void NeuralPoints::Transform(const Rigid3& T_new_old) {
  const Eigen::Matrix3d R = T_new_old.RotationMatrix();
  for (NeuralPoint& point : points_) {
    point.position = T_new_old * point.position;
    point.orientation = (point.orientation * T_new_old.rotation.conjugate()).normalized();
    point.covariance = R * point.covariance * R.transpose();
    point.to_radar = R * point.to_radar;
    const Eigen::Array3d cell = CellOf(point.position);
    point.cell = CellKey(cell.x(), cell.y(), cell.z());
  }
  Rebuild();
}

void NeuralPoints::Rebuild() {
  cells_.clear();
  occupied_.Clear();
  for (std::size_t k = points_.size(); k-- > 0;) {
    const auto [at, is_new] = cells_.try_emplace(points_[k].cell, static_cast<std::int32_t>(k));
    points_[k].next = is_new ? -1 : at->second;
    if (!is_new) at.value() = static_cast<std::int32_t>(k);
    const Eigen::Vector3i cell = CellOfKey(points_[k].cell);
    occupied_.Insert(cell.x(), cell.y(), cell.z());
  }
}

Neighbors NeuralPoints::Nearest(const Eigen::Vector3d& position, int except) const {
  Neighbors neighbors;
  if (!position.allFinite()) return neighbors;
  ForEachNear(position, [&](int k, double squared_distance) {
    if (k != except) Insert(k, squared_distance, options_.num_neighbors, &neighbors);
  });
  return neighbors;
}

double NeuralPoints::Support(const Eigen::Vector3d& position) const {
  if (!position.allFinite()) return 0.0;
  const double inverse = 0.5 * inverse_resolution_ * inverse_resolution_;
  double support = 0.0;
  ForEachNear(position, [&](int k, double squared_distance) {
    support += std::sqrt(point(k).certainty) * std::exp(-inverse * squared_distance);
  });
  return support;
}

int NeuralPoints::At(const Eigen::Vector3d& position) const {
  const Eigen::Array3d cell = CellOf(position);
  const auto at = cells_.find(CellKey(cell.x(), cell.y(), cell.z()));
  return at == cells_.end() ? -1 : at->second;
}

}  // namespace radive
