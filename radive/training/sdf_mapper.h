// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <deque>
#include <vector>

#include "radive/neural_map/neural_map_options.h"
#include "radive/neural_map/neural_points.h"
#include "radive/training/sdf_labels.h"
#include "radive/training/sdf_trainer.h"
#include "radive/training/sdf_training_options.h"

namespace radive {

// A keyframe as the neural map takes it in.
struct MapKeyframe {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // of the radar, map frame [m]
  std::vector<MapReturn> returns;
  bool is_planar = false;  // the radar measures no elevation
};

// Builds a neural map keyframe by keyframe: neural points from the returns, labels from the last
// keyframes, training of the features that the keyframe touched, and forgetting. Deterministic.
class SdfMapper {
 public:
  // The options must be valid.
  SdfMapper(const NeuralMapOptions& map_options, const SdfTrainingOptions& training_options);

  TrainingResult AddKeyframe(const MapKeyframe& keyframe);

  void Clear();

  const NeuralPoints& map() const { return map_; }
  const SdfDecoder& decoder() const { return decoder_; }

  // Median over the points that the last keyframe saw of how many neural points lie within twice
  // the resolution, themselves included: few where the sensor is too sparse for a field.
  double MedianNeighbors() const;

  // Fresh samples about the points of the last keyframe, with labels from the same window as in its
  // training: for held-out errors.
  std::vector<SdfSample> HeldOutSamples(const SdfTrainingOptions& options) const;

 private:
  std::vector<const LabelScan*> Window() const;

  const SdfTrainingOptions training_options_;
  NeuralPoints map_;
  SdfDecoder decoder_;
  std::deque<LabelScan> scans_;
  std::vector<int> seen_;  // by the last keyframe
  int num_keyframes_ = 0;
  bool is_planar_ = false;  // the last keyframe
};

}  // namespace radive
