// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/voxel_window.h"

#include <glog/logging.h>

#include <utility>

namespace radive {

VoxelWindow::VoxelWindow(const NdtOptions& options)
    : options_(options),
      grid_({options.voxel_size[0], options.voxel_size[1], options.voxel_size[2]}) {}

std::uint32_t VoxelWindow::VoxelAt(const Eigen::Vector3d& point) {
  const std::uint64_t key = grid_.Key(point);
  const auto number = static_cast<std::uint32_t>(unused_.empty() ? voxels_.size() : unused_.back());
  const auto [entry, is_new] = index_.try_emplace(key, number);
  if (!is_new) return entry->second;
  if (unused_.empty()) {
    voxels_.emplace_back();
  } else {
    unused_.pop_back();
  }
  Voxel& voxel = voxels_[number];
  voxel = Voxel();
  voxel.key = key;
  voxel.place = point;
  return number;
}

void VoxelWindow::AddPart(const Part& part, int sign) {
  Voxel& voxel = voxels_[part.voxel];
  voxel.sums.Add(part.sums, sign);
  voxel.part = -1;
  if (!std::exchange(voxel.is_changed, true)) changed_.push_back(part.voxel);
}

std::vector<int> VoxelWindow::AddKeyframe(const std::vector<Eigen::Vector3d>& points,
                                          const std::vector<double>& weights,
                                          int num_keyframes) {
  CHECK_EQ(points.size(), weights.size());
  std::vector<Part> parts;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t number = VoxelAt(points[i]);
    Voxel& voxel = voxels_[number];
    if (voxel.part < 0) {
      voxel.part = static_cast<int>(parts.size());
      parts.push_back({number, VoxelSums()});
    }
    parts[static_cast<std::size_t>(voxel.part)].sums.Add(points[i] - voxel.place, weights[i]);
  }
  for (const Part& part : parts) AddPart(part, 1);
  keyframes_.push_back(std::move(parts));
  while (static_cast<int>(keyframes_.size()) > num_keyframes) {
    for (const Part& part : keyframes_.front()) AddPart(part, -1);
    keyframes_.pop_front();
  }
  return UpdateGaussians();
}

std::vector<int> VoxelWindow::UpdateGaussians() {
  std::vector<int> moved(gaussians_.size(), -1);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < gaussians_.size(); ++i) {
    if (voxels_[voxel_of_[i]].is_changed) continue;
    moved[i] = static_cast<int>(kept);
    gaussians_[kept] = gaussians_[i];
    voxel_of_[kept++] = voxel_of_[i];
  }
  gaussians_.resize(kept);
  voxel_of_.resize(kept);
  for (const std::uint32_t number : changed_) {
    Voxel& voxel = voxels_[number];
    voxel.is_changed = false;
    if (voxel.sums.count >= options_.min_points && voxel.sums.count > 0) {
      gaussians_.push_back(voxel.sums.Gaussian(voxel.place, options_.epsilon));
      voxel_of_.push_back(number);
    }
    if (voxel.sums.count > 0) continue;
    index_.erase(voxel.key);
    unused_.push_back(number);
  }
  changed_.clear();
  return moved;
}

}  // namespace radive
