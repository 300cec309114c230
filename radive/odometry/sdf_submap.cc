// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/sdf_submap.h"

#include <algorithm>
#include <deque>
#include <future>
#include <optional>
#include <string>
#include <utility>

#include "radive/ndt/gaussian_builder.h"
#include "radive/neural_map/surface_extractor.h"
#include "radive/sensor/radar_noise_model.h"
#include "radive/training/sdf_mapper.h"

namespace radive {
namespace {

// What the training of a keyframe hands over.
struct TrainedSubmap {
  // On the heap: the search keeps their address when this is moved.
  std::unique_ptr<const std::vector<Gaussian3>> gaussians;
  std::unique_ptr<PairSearch> search;
  double median_neighbors = 0.0;
};

NeuralMapOptions MapOptions(const OdometryOptions& options) {
  NeuralMapOptions map = options.neural_map;
  map.max_age = std::min(map.max_age, options.submap.num_keyframes);
  return map;
}

// Flattens along the unit normal n by the share a.
Eigen::Matrix3d Flattened(const Eigen::Matrix3d& S, const Eigen::Vector3d& n, double a) {
  const Eigen::Matrix3d P = Eigen::Matrix3d::Identity() - a * n * n.transpose();
  return P * S * P;
}

// Everything that the training thread owns.
class SurfaceWorker {
 public:
  explicit SurfaceWorker(const OdometryOptions& options)
      : options_(options), mapper_(MapOptions(options), options.training) {
    if (options.sdf_submap.record) {
      record_.emplace(options.sdf_submap.record_grid_spacing, options.surface.min_support);
    }
  }

  TrainedSubmap Add(const Keyframe& keyframe) {
    MapKeyframe entry;
    entry.origin = keyframe.T_world_radar.translation;
    entry.is_planar = keyframe.is_planar;
    const Eigen::Matrix3d R = keyframe.T_world_radar.RotationMatrix();
    for (std::size_t i = 0; i < keyframe.returns.size(); ++i) {
      const Eigen::Vector3d& p_radar = keyframe.returns[i].position;
      const Eigen::Matrix3d noise =
          PositionCovariance(p_radar, options_.sensor, keyframe.is_planar);
      entry.returns.push_back(
          {keyframe.T_world_radar * p_radar, keyframe.weights[i], R * noise * R.transpose()});
    }
    if (record_) {
      record_->BeforeKeyframe(mapper_.map(), mapper_.decoder(), entry.origin, num_keyframes_);
    }
    mapper_.AddKeyframe(entry);
    ++num_keyframes_;
    if (options_.sdf_submap.source == SdfSubmapOptions::Source::kReturns) {
      window_.push_back(std::move(entry.returns));
      while (static_cast<int>(window_.size()) > options_.submap.num_keyframes) window_.pop_front();
    }
    TrainedSubmap trained;
    trained.median_neighbors = mapper_.MedianNeighbors();
    const std::vector<SurfacePoint> surface = SelectSurface(
        evaluation_.Update(mapper_.map(), mapper_.decoder(), options_.surface.leave_out_self),
        options_.surface);
    trained.gaussians = std::make_unique<const std::vector<Gaussian3>>(
        options_.sdf_submap.source == SdfSubmapOptions::Source::kPoints
            ? GaussiansOfPoints(surface)
            : GaussiansOfReturnsNear(surface));
    trained.search = std::make_unique<PairSearch>(*trained.gaussians);
    return trained;
  }

  std::optional<SurfaceRecord> TakeRecord() {
    if (record_) record_->Finish(mapper_.map(), mapper_.decoder());
    return std::exchange(record_, std::nullopt);
  }

 private:
  bool IsVoxel() const { return options_.ndt.IsVoxel(); }

  Gaussian3 PointGaussian(const Eigen::Vector3d& mean,
                          const Eigen::Matrix3d& covariance,
                          const SurfacePoint& point) const {
    Gaussian3 gaussian;
    gaussian.mean = mean;
    gaussian.covariance = Flattened(covariance, point.normal, options_.sdf_submap.flatten);
    gaussian.covariance.diagonal().array() += options_.ndt.epsilon;
    gaussian.weight = point.weight;
    gaussian.confidence = point.weight;
    return gaussian;
  }

  std::vector<Gaussian3> VoxelGaussians(const std::vector<Eigen::Vector3d>& points,
                                        const std::vector<double>& weights) const {
    std::vector<Gaussian3> gaussians = GaussiansOfVoxels(points, weights, options_.ndt);
    for (Gaussian3& gaussian : gaussians) gaussian.confidence = gaussian.weight;
    return gaussians;
  }

  std::vector<Gaussian3> GaussiansOfPoints(const std::vector<SurfacePoint>& surface) const {
    std::vector<Gaussian3> gaussians;
    std::vector<Eigen::Vector3d> points;
    std::vector<double> weights;
    for (const SurfacePoint& point : surface) {
      if (IsVoxel()) {
        points.push_back(point.position);
        weights.push_back(point.weight);
      } else {
        const Eigen::Matrix3d& covariance = mapper_.map().point(point.index).covariance;
        gaussians.push_back(PointGaussian(point.position, covariance, point));
      }
    }
    return IsVoxel() ? VoxelGaussians(points, weights) : gaussians;
  }

  // Each return is moved as far as its surface point's field, taken as linear, tells.
  std::vector<Gaussian3> GaussiansOfReturnsNear(const std::vector<SurfacePoint>& surface) const {
    const NeuralPoints& map = mapper_.map();
    std::vector<int> surface_of(static_cast<std::size_t>(map.size()), -1);
    for (std::size_t i = 0; i < surface.size(); ++i) {
      surface_of[static_cast<std::size_t>(surface[i].index)] = static_cast<int>(i);
    }
    std::vector<Gaussian3> gaussians;
    std::vector<Eigen::Vector3d> points;
    std::vector<double> weights;
    for (const std::vector<MapReturn>& returns : window_) {
      for (const MapReturn& entry : returns) {
        const int at = map.At(entry.position);
        const int i = at < 0 ? -1 : surface_of[static_cast<std::size_t>(at)];
        if (i < 0) continue;
        const SurfacePoint& point = surface[static_cast<std::size_t>(i)];
        const double distance =
            point.sdf + point.normal.dot(entry.position - map.point(at).position);
        const Eigen::Vector3d position =
            entry.position - options_.surface.projection * distance * point.normal;
        if (IsVoxel()) {
          points.push_back(position);
          weights.push_back(point.weight);
        } else {
          gaussians.push_back(PointGaussian(position, entry.covariance, point));
        }
      }
    }
    return IsVoxel() ? VoxelGaussians(points, weights) : gaussians;
  }

  const OdometryOptions options_;
  SdfMapper mapper_;
  SurfaceEvaluation evaluation_;
  std::optional<SurfaceRecord> record_;
  int num_keyframes_ = 0;
  std::deque<std::vector<MapReturn>> window_;
};

class SdfSubmap : public Submap {
 public:
  explicit SdfSubmap(const OdometryOptions& options)
      : options_(options),
        raw_(MakeRawSubmap(options.submap, options.ndt, options.sensor)),
        worker_(std::make_unique<SurfaceWorker>(options)),
        mode_(FirstMode()) {}

  ~SdfSubmap() override {
    if (pending_.valid()) pending_.wait();
  }

  void NextScan() override {
    if (pending_.valid() && ++scans_pending_ > options_.sdf_submap.handover_scans) Join();
  }

  void AddKeyframe(Keyframe keyframe) override {
    if (pending_.valid()) Join();
    if (mode_ != Mode::kSurface) raw_->AddKeyframe(keyframe);
    if (mode_ == Mode::kBypass) return;
    ++num_keyframes_;
    if (options_.sdf_submap.bypass && mode_ == Mode::kSurface &&
        options_.sdf_submap.handover_scans > 0) {
      AppendRaw(keyframe);
    }
    const auto policy = options_.num_threads > 1 ? std::launch::async : std::launch::deferred;
    pending_ = std::async(policy, [worker = worker_.get(), keyframe = std::move(keyframe)] {
      return worker->Add(keyframe);
    });
    scans_pending_ = 0;
    if (options_.sdf_submap.handover_scans == 0) Join();
  }

  void Clear() override {
    if (pending_.valid()) pending_.get();
    raw_->Clear();
    trained_ = TrainedSubmap();
    worker_ = std::make_unique<SurfaceWorker>(options_);
    if (mode_ == Mode::kSurface) mode_ = FirstMode();
    num_keyframes_ = 0;
  }

  std::optional<SurfaceRecord> TakeSurfaceRecord() override {
    if (pending_.valid()) Join();
    return worker_ != nullptr ? worker_->TakeRecord() : std::nullopt;
  }

  const PairSearch* search() const override {
    return mode_ == Mode::kSurface ? trained_.search.get() : raw_->search();
  }

  std::vector<std::string> TakeNotes() override { return std::exchange(notes_, {}); }

 private:
  enum class Mode { kUndecided, kSurface, kBypass };

  Mode FirstMode() const { return options_.sdf_submap.bypass ? Mode::kUndecided : Mode::kSurface; }

  // Until the training hands over, the newest keyframe stands in the submap as it was measured:
  // around a corner it may be all that there is to see.
  void AppendRaw(const Keyframe& keyframe) {
    const auto raw = MakeRawSubmap(options_.submap, options_.ndt, options_.sensor);
    raw->AddKeyframe(keyframe);
    std::vector<Gaussian3> gaussians = *trained_.gaussians;
    const std::vector<Gaussian3>& newest = raw->search()->submap();
    gaussians.insert(gaussians.end(), newest.begin(), newest.end());
    trained_.search.reset();
    trained_.gaussians = std::make_unique<const std::vector<Gaussian3>>(std::move(gaussians));
    trained_.search = std::make_unique<PairSearch>(*trained_.gaussians);
  }

  void Join() {
    TrainedSubmap trained = pending_.get();
    const bool is_useful =
        static_cast<int>(trained.gaussians->size()) >= options_.registration.min_gaussians;
    if (mode_ == Mode::kUndecided && num_keyframes_ >= options_.sdf_submap.bypass_keyframes) {
      Decide(trained, is_useful);
    }
    // A surface of next to nothing is worse than the one before.
    if (mode_ == Mode::kSurface && (is_useful || !options_.sdf_submap.bypass)) {
      trained_ = std::move(trained);
    }
    if (mode_ == Mode::kBypass) worker_.reset();
  }

  void Decide(const TrainedSubmap& trained, bool is_useful) {
    const bool is_dense = trained.median_neighbors >= options_.sdf_submap.bypass_neighbors;
    const std::string measured =
        "neural points have " + std::to_string(static_cast<int>(trained.median_neighbors)) +
        " neighbours (median), " + std::to_string(trained.gaussians->size()) +
        " Gaussians lie on the surface";
    if (!is_dense || !is_useful) {
      mode_ = Mode::kBypass;
      notes_.push_back("surface extraction is bypassed, the submap stays raw: " + measured);
      return;
    }
    mode_ = Mode::kSurface;
    raw_->Clear();
    notes_.push_back("the submap is the extracted surface from here on: " + measured);
  }

  const OdometryOptions options_;
  std::unique_ptr<Submap> raw_;
  std::unique_ptr<SurfaceWorker> worker_;  // in use by pending_ while that is valid
  std::future<TrainedSubmap> pending_;
  int scans_pending_ = 0;
  int num_keyframes_ = 0;
  Mode mode_;
  TrainedSubmap trained_;
  std::vector<std::string> notes_;
};

}  // namespace

std::unique_ptr<Submap> MakeSdfSubmap(const OdometryOptions& options) {
  return std::make_unique<SdfSubmap>(options);
}

}  // namespace radive
