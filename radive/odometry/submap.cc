// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/submap.h"

#include <algorithm>
#include <deque>
#include <numeric>
#include <utility>

#include "radive/ndt/gaussian_builder.h"
#include "radive/ndt/voxel_window.h"
#include "radive/odometry/sdf_submap.h"

namespace radive {
namespace {

// The returns of the last keyframes as single Gaussians, as they were measured.
class PointSubmap : public Submap {
 public:
  PointSubmap(const SubmapOptions& options, const NdtOptions& ndt, const SensorOptions& sensor)
      : options_(options), ndt_(ndt), sensor_(sensor) {}

  void AddKeyframe(Keyframe keyframe) override {
    std::vector<Gaussian3> gaussians =
        GaussiansOfReturns(keyframe.returns, keyframe.weights, sensor_, ndt_, keyframe.is_planar);
    const Eigen::Matrix3d R = keyframe.T_world_radar.RotationMatrix();
    for (Gaussian3& gaussian : gaussians) {
      gaussian.mean = R * gaussian.mean + keyframe.T_world_radar.translation;
      gaussian.covariance = R * gaussian.covariance * R.transpose();
    }
    std::size_t num_gone = 0;
    window_.push_back(gaussians.size());
    while (static_cast<int>(window_.size()) > options_.num_keyframes) {
      num_gone += window_.front();
      window_.pop_front();
    }
    std::vector<int> moved(gaussians_.size());
    std::iota(moved.begin(), moved.end(), -static_cast<int>(num_gone));
    std::replace_if(
        moved.begin(), moved.end(), [](int index) { return index < 0; }, -1);
    gaussians_.erase(gaussians_.begin(),
                     gaussians_.begin() + static_cast<std::ptrdiff_t>(num_gone));
    gaussians_.insert(gaussians_.end(), gaussians.begin(), gaussians.end());
    if (search_ == nullptr) {
      search_ = std::make_unique<PairSearch>(gaussians_);
    } else {
      search_->Update(gaussians_, moved);
    }
  }

  void Clear() override {
    window_.clear();
    search_.reset();
    gaussians_.clear();
  }

  const PairSearch* search() const override { return search_.get(); }

 private:
  const SubmapOptions options_;
  const NdtOptions ndt_;
  const SensorOptions sensor_;
  std::deque<std::size_t> window_;  // Gaussians of each keyframe
  std::vector<Gaussian3> gaussians_;
  std::unique_ptr<PairSearch> search_;
};

// The voxels of the returns of the last keyframes.
class VoxelSubmap : public Submap {
 public:
  VoxelSubmap(const SubmapOptions& options, const NdtOptions& ndt)
      : options_(options), ndt_(ndt), voxels_(ndt) {}

  void AddKeyframe(Keyframe keyframe) override {
    std::vector<Eigen::Vector3d> points;
    points.reserve(keyframe.returns.size());
    for (const RadarReturn& radar_return : keyframe.returns) {
      points.push_back(keyframe.T_world_radar * radar_return.position);
    }
    const std::vector<int> moved =
        voxels_.AddKeyframe(points, keyframe.weights, options_.num_keyframes);
    if (search_ == nullptr) {
      search_ = std::make_unique<PairSearch>(voxels_.gaussians());
    } else {
      search_->Update(voxels_.gaussians(), moved);
    }
  }

  void Clear() override {
    search_.reset();
    voxels_ = VoxelWindow(ndt_);
  }

  const PairSearch* search() const override { return search_.get(); }

 private:
  const SubmapOptions options_;
  const NdtOptions ndt_;
  VoxelWindow voxels_;
  std::unique_ptr<PairSearch> search_;
};

}  // namespace

std::unique_ptr<Submap> MakeRawSubmap(const SubmapOptions& options,
                                      const NdtOptions& ndt,
                                      const SensorOptions& sensor) {
  if (ndt.IsVoxel()) return std::make_unique<VoxelSubmap>(options, ndt);
  return std::make_unique<PointSubmap>(options, ndt, sensor);
}

std::unique_ptr<Submap> MakeSubmap(const OdometryOptions& options) {
  return options.submap.type == SubmapOptions::Type::kSdf
             ? MakeSdfSubmap(options)
             : MakeRawSubmap(options.submap, options.ndt, options.sensor);
}

}  // namespace radive
