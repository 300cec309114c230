// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "radive/neural_map/neural_points.h"
#include "radive/training/sdf_training_options.h"

namespace radive {

// The returns of a keyframe, as labels are made from them.
struct LabelScan {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // of the radar, map frame [m]
  std::vector<Eigen::Vector3d> points;               // map frame [m]
  std::vector<double> weights;                       // of the returns [-]
};

// What a training sample should learn.
struct SdfLabel {
  double distance = 0.0;  // signed, positive towards the radar, clamped [m]
  double weight = 1.0;    // mean weight of the returns it comes from [-]
};

// The plane of what the scans saw near a position.
struct LocalPlane {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // weighted mean [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // unit, towards the radar
  double weight = 1.0;                                // mean weight [-]
};

// Labels from the points of a window of keyframes or, smooth ones, from the neural points that all
// keyframes have left.
class SdfLabels {
 public:
  // Points that are not finite or have no positive weight are left out. `map` is asked for smooth
  // labels only and must outlive this object. `is_planar`: the radar measures no elevation.
  SdfLabels(const std::vector<const LabelScan*>& window,
            const NeuralPoints& map,
            const SdfTrainingOptions& options,
            bool is_planar = false);
  ~SdfLabels();
  SdfLabels(const SdfLabels&) = delete;
  SdfLabels& operator=(const SdfLabels&) = delete;

  int num_points() const;

  // Nothing when there are too few points: three for a plane, else one. `near`: the neural points
  // near the position.
  std::optional<SdfLabel> At(const Eigen::Vector3d& position,
                             const std::vector<NearPoint>& near) const;
  std::optional<SdfLabel> At(const Eigen::Vector3d& position) const;

  // The plane of the `label_points` nearest scan points or, with smooth labels, of the neural
  // points nearby; nothing with fewer than three points.
  std::optional<LocalPlane> PlaneAt(const Eigen::Vector3d& position,
                                    const std::vector<NearPoint>& near) const;

 private:
  struct Tree;
  std::optional<LocalPlane> NearestPlane(const Eigen::Vector3d& position) const;
  std::optional<LocalPlane> SmoothPlane(const Eigen::Vector3d& position,
                                        const std::vector<NearPoint>& near) const;

  bool IsSmooth() const { return options_.label == SdfTrainingOptions::Label::kSmooth; }

  const NeuralPoints& map_;
  const SdfTrainingOptions options_;
  const bool is_planar_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace radive
