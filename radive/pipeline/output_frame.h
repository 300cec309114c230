// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "radive/config/run_config.h"
#include "radive/geometry/rigid3.h"
#include "radive/odometry/odometry.h"
#include "radive/odometry/odometry_result.h"

namespace radive {

// Turns the results of the odometry, which are of its body (motion.body), into those of the body
// that output.frame names, which is rigidly joined to it. The world frame becomes that body's at
// the first scan. Changes nothing where both are the same, not a bit.
class OutputFrame {
 public:
  // `first_radar`: of the first scan, as RadarScan::radar has it.
  OutputFrame(const RunConfig& config, int first_radar);

  // T_world_body, T_world_radar, covariance and keyframe points of `result`.
  void Apply(OdometryResult* result) const;
  void Apply(RadarSurface* surface) const;  // T_world_map

  // Of the bodies on the vehicle: that of the trajectory that is written, and the one whose poses
  // the ground truth has (see ReferenceOptions).
  const Rigid3& T_output_reference() const { return T_output_reference_; }

 private:
  bool is_body_ = false;  // of the odometry
  Rigid3 T_body_output_;
  Rigid3 T_output_reference_;
};

}  // namespace radive
