// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/training/sdf_mapper.h"

#include <glog/logging.h>

#include <algorithm>

namespace radive {
namespace {

// Of the first joint training, which starts from random weights.
constexpr int kFirstJointIterations = 30;

SdfDecoder FirstDecoder(const NeuralMapOptions& map, const SdfTrainingOptions& training) {
  if (training.joint_keyframes == 0 || map.decoder != nullptr) return map.Decoder();
  return RandomDecoder(map.feature_dim,
                       map.feature_dim == 4 ? 16 : 32,
                       SdfDecoder::Activation::kSoftsign,
                       training.seed);
}

}  // namespace

SdfMapper::SdfMapper(const NeuralMapOptions& map_options,
                     const SdfTrainingOptions& training_options)
    : training_options_(training_options),
      map_(map_options),
      decoder_(FirstDecoder(map_options, training_options)) {
  std::string error;
  CHECK(training_options.IsValid(&error)) << error;
}

TrainingResult SdfMapper::AddKeyframe(const MapKeyframe& keyframe) {
  const int index = num_keyframes_++;
  map_.Prune(keyframe.origin, index);
  seen_ = map_.AddKeyframe(keyframe.returns, index, keyframe.origin);

  LabelScan scan;
  scan.origin = keyframe.origin;
  scan.points.reserve(keyframe.returns.size());
  scan.weights.reserve(keyframe.returns.size());
  for (const MapReturn& entry : keyframe.returns) {
    scan.points.push_back(entry.position);
    scan.weights.push_back(entry.weight);
  }
  scans_.push_back(std::move(scan));
  while (static_cast<int>(scans_.size()) > training_options_.label_window) scans_.pop_front();

  is_planar_ = keyframe.is_planar;
  const SdfLabels labels(Window(), map_, training_options_, is_planar_);
  InitialisePoints(&map_, seen_, labels, index);
  const std::vector<SdfSample> samples = DrawSamples(map_, seen_, labels, index, training_options_);
  if (index >= training_options_.joint_keyframes) {
    return TrainFeatures(samples, seen_, decoder_, training_options_, &map_);
  }
  SdfTrainingOptions options = training_options_;
  if (index == 0) {
    options.solver.max_iterations = std::max(options.solver.max_iterations, kFirstJointIterations);
  }
  return TrainDecoder(samples, seen_, options, &map_, &decoder_);
}

void SdfMapper::Clear() {
  map_.Clear();
  scans_.clear();
  seen_.clear();
}

double SdfMapper::MedianNeighbors() const {
  if (seen_.empty()) return 0.0;
  std::vector<int> counts;
  for (const int k : seen_) counts.push_back(map_.Nearest(map_.point(k).position).count);
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return *middle;
}

std::vector<SdfSample> SdfMapper::HeldOutSamples(const SdfTrainingOptions& options) const {
  const SdfLabels labels(Window(), map_, options, is_planar_);
  // No keyframe has a negative index: other draws than in training.
  return DrawSamples(map_, seen_, labels, -1 - num_keyframes_, options);
}

std::vector<const LabelScan*> SdfMapper::Window() const {
  std::vector<const LabelScan*> window;
  for (const LabelScan& scan : scans_) window.push_back(&scan);
  return window;
}

}  // namespace radive
