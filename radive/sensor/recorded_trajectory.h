// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "radive/geometry/matrix_pose.h"
#include "radive/sensor/trajectory.h"

namespace radive {

// A line of a trajectory file, as precisely as the file has it.
struct RecordedPose {
  std::int64_t stamp_ns = 0;  // [ns]; 0 in formats without stamps

  // The same stamp [s] rounded to the double that evo computes with: matching stamps as evo does
  // means taking differences of these, 0.2 us apart at today's dates.
  double stamp_s = 0.0;

  MatrixPose T_world_body;

  // Length of the quaternion in the file, where it has one; 0 for (almost) zero ones.
  double quaternion_norm = 1.0;
};

using RecordedTrajectory = std::vector<RecordedPose>;

inline Trajectory ToTrajectory(const RecordedTrajectory& recorded) {
  Trajectory trajectory;
  trajectory.reserve(recorded.size());
  for (const RecordedPose& pose : recorded) {
    trajectory.push_back({pose.stamp_ns, pose.T_world_body.ToRigid3()});
  }
  return trajectory;
}

// The double nearest to a stamp [s].
inline double StampSeconds(std::int64_t stamp_ns) {
  // Whole seconds are exact in a double, so the sum rounds once.
  const std::int64_t whole = stamp_ns / 1'000'000'000;
  const std::int64_t rest = stamp_ns % 1'000'000'000;
  return static_cast<double>(whole) + static_cast<double>(rest) / 1e9;
}

inline RecordedTrajectory ToRecordedTrajectory(const Trajectory& trajectory) {
  RecordedTrajectory recorded;
  recorded.reserve(trajectory.size());
  for (const StampedPose& pose : trajectory) {
    recorded.push_back({pose.stamp_ns, StampSeconds(pose.stamp_ns), MatrixPose(pose.T_world_body)});
  }
  return recorded;
}

}  // namespace radive
