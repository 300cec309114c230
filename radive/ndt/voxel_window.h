// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tsl/robin_map.h>

#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/ndt/ndt_options.h"
#include "radive/ndt/voxel_sums.h"
#include "radive/util/cell_key.h"

namespace radive {

// GaussiansOfVoxels() of the points of the last keyframes: as one comes and one goes, only the
// voxels that these touch are formed anew.
class VoxelWindow {
 public:
  explicit VoxelWindow(const NdtOptions& options);

  // The points of a keyframe, in the frame of the voxels; of the keyframes before, num_keyframes -
  // 1 are kept. Returns where each Gaussian is now; -1: gone, or changed and now among the last.
  std::vector<int> AddKeyframe(const std::vector<Eigen::Vector3d>& points,
                               const std::vector<double>& weights,
                               int num_keyframes);

  // Those that have not changed come first.
  const std::vector<Gaussian3>& gaussians() const { return gaussians_; }

 private:
  struct Voxel {
    std::uint64_t key = 0;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // its first point, see VoxelSums
    VoxelSums sums;
    int part = -1;  // of the keyframe that is being added
    bool is_changed = false;
  };
  // What a keyframe has in a voxel.
  struct Part {
    std::uint32_t voxel;
    VoxelSums sums;
  };

  std::uint32_t VoxelAt(const Eigen::Vector3d& point);
  void AddPart(const Part& part, int sign);
  std::vector<int> UpdateGaussians();

  NdtOptions options_;
  VoxelGrid grid_;
  tsl::robin_map<std::uint64_t, std::uint32_t, CellKeyHash> index_;
  std::vector<Voxel> voxels_;
  std::vector<std::uint32_t> unused_;   // of voxels_
  std::vector<std::uint32_t> changed_;  // since the Gaussians were formed
  std::deque<std::vector<Part>> keyframes_;
  std::vector<Gaussian3> gaussians_;
  std::vector<std::uint32_t> voxel_of_;  // each Gaussian
};

}  // namespace radive
