// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "radive/preprocessing/preprocessing_options.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// The limits of range, azimuth and elevation. No angle is computed for a position: sines and
// cosines of the limits are compared with its coordinates.
class FieldOfView {
 public:
  explicit FieldOfView(const PreprocessingOptions& options);

  // Whether a position in the radar frame [m] lies in it, edges included. False for positions that
  // are not finite.
  bool Contains(const Eigen::Vector3d& p_radar) const;

  // Whether it lies within the ranges, whatever its angles.
  bool IsInRange(const Eigen::Vector3d& p_radar) const;

 private:
  double min_range_, max_range_;
  Eigen::Vector2d right_, left_;  // directions of the limits of the azimuth
  bool is_round_;                 // all azimuths
  bool is_wide_;                  // more than half of them
  double min_sine_, max_sine_;    // of the elevation
};

// The returns in the field of view, in their order.
std::vector<RadarReturn> GateFieldOfView(const std::vector<RadarReturn>& returns,
                                         const PreprocessingOptions& options);

}  // namespace radive
