// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "radive/ego_velocity/ego_velocity.h"
#include "radive/geometry/pose_covariance.h"
#include "radive/geometry/rigid3.h"
#include "radive/preprocessing/drop_counts.h"

namespace radive {

// What one call of Odometry::AddScan found.
struct OdometryResult {
  enum class Status {
    kRegistered,  // aligned with the submap
    kPredicted,   // moved by the prediction alone: too few returns, or registration failed
    kStanding,    // the Doppler says that the radar does not move: the pose is kept
    kSkipped,     // the scan cannot be used (stamp goes back or repeats); the pose is repeated
  };

  int index = 0;              // of the scan in the drive, from 0
  std::int64_t stamp_ns = 0;  // [ns]
  Status status = Status::kSkipped;
  std::string reason;  // why the scan was not registered; empty when it was

  // Pose of what the trajectory is of (motion.body): the radar of the first scan, or the vehicle.
  // The world frame is its frame at the first scan.
  Rigid3 T_world_body;
  // Pose of the radar that this scan is of. The same, where there is one radar and no vehicle.
  Rigid3 T_world_radar;
  // Of T_world_body, order [rotation (3), translation (3)], both in the world frame: the true pose
  // is (exp(dr) R, t + dt) [rad^2, rad m, m^2]. Relative to the submap, so it does not grow with
  // drift.
  Matrix6d covariance = Matrix6d::Zero();

  EgoVelocity ego_velocity;

  int num_returns = 0;      // in the scan
  int num_kept = 0;         // left after all filters
  DropCounts dropped;       // why the others are not
  int num_gaussians = 0;    // source Gaussians
  int num_pairs = 0;        // correspondences of the last association
  int num_iterations = 0;   // LM steps, all associations together
  double cost = 0.0;        // final cost of registration
  bool degenerate = false;  // the scan leaves at least one direction unobserved
  bool is_keyframe = false;
  std::vector<Eigen::Vector3d> keyframe_points;  // of a keyframe, world frame [m]; for maps

  // Wall time of each stage [ms].
  struct Times {
    double preprocessing = 0.0;
    double ego_velocity = 0.0;
    double pair_search = 0.0;
    double registration = 0.0;  // without pair search
    double submap = 0.0;
    double total = 0.0;
  } times_ms;
};

// "registered", "predicted", "standing", "skipped".
const char* ToString(OdometryResult::Status status);

}  // namespace radive
