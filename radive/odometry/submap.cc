// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/submap.h"

#include <deque>
#include <utility>

#include "radive/ndt/gaussian_builder.h"
#include "radive/odometry/sdf_submap.h"

namespace radive {
namespace {

// The points of the last keyframes, as they were measured.
class RawSubmap : public Submap {
 public:
  RawSubmap(const SubmapOptions& options, const NdtOptions& ndt, const SensorOptions& sensor)
      : options_(options), ndt_(ndt), sensor_(sensor) {}

  void AddKeyframe(Keyframe keyframe) override {
    Entry entry;
    if (!ndt_.IsVoxel()) {
      entry.gaussians =
          GaussiansOfReturns(keyframe.returns, keyframe.weights, sensor_, ndt_, keyframe.is_planar);
      const Eigen::Matrix3d R = keyframe.T_world_radar.RotationMatrix();
      for (Gaussian3& gaussian : entry.gaussians) {
        gaussian.mean = R * gaussian.mean + keyframe.T_world_radar.translation;
        gaussian.covariance = R * gaussian.covariance * R.transpose();
      }
    } else {
      entry.points.reserve(keyframe.returns.size());
      for (const RadarReturn& radar_return : keyframe.returns) {
        entry.points.push_back(keyframe.T_world_radar * radar_return.position);
      }
      entry.weights = std::move(keyframe.weights);
    }
    window_.push_back(std::move(entry));
    while (static_cast<int>(window_.size()) > options_.num_keyframes) window_.pop_front();
    Rebuild();
  }

  void Clear() override {
    window_.clear();
    search_.reset();
    gaussians_.clear();
  }

  const PairSearch* search() const override { return search_.get(); }

 private:
  struct Entry {
    std::vector<Gaussian3> gaussians;     // kPoint, world frame
    std::vector<Eigen::Vector3d> points;  // kVoxel, world frame
    std::vector<double> weights;
  };

  void Rebuild() {
    search_.reset();
    gaussians_.clear();
    if (!ndt_.IsVoxel()) {
      for (const Entry& entry : window_) {
        gaussians_.insert(gaussians_.end(), entry.gaussians.begin(), entry.gaussians.end());
      }
    } else {
      std::vector<Eigen::Vector3d> points;
      std::vector<double> weights;
      for (const Entry& entry : window_) {
        points.insert(points.end(), entry.points.begin(), entry.points.end());
        weights.insert(weights.end(), entry.weights.begin(), entry.weights.end());
      }
      gaussians_ = GaussiansOfVoxels(points, weights, ndt_);
    }
    search_ = std::make_unique<PairSearch>(gaussians_);
  }

  const SubmapOptions options_;
  const NdtOptions ndt_;
  const SensorOptions sensor_;
  std::deque<Entry> window_;
  std::vector<Gaussian3> gaussians_;
  std::unique_ptr<PairSearch> search_;
};

}  // namespace

std::unique_ptr<Submap> MakeRawSubmap(const SubmapOptions& options,
                                      const NdtOptions& ndt,
                                      const SensorOptions& sensor) {
  return std::make_unique<RawSubmap>(options, ndt, sensor);
}

std::unique_ptr<Submap> MakeSubmap(const OdometryOptions& options) {
  return options.submap.type == SubmapOptions::Type::kSdf
             ? MakeSdfSubmap(options)
             : MakeRawSubmap(options.submap, options.ndt, options.sensor);
}

}  // namespace radive
