// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "radive/geometry/matrix_pose.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// The poses of two trajectories, matched: reference[i] belongs to estimate[i].
struct MatchedPoses {
  std::vector<MatrixPose> reference;
  std::vector<MatrixPose> estimate;
};

// Matches poses by time as evo does: each pose of the shorter trajectory (the estimate, when both
// are equally long) takes the nearest stamp of the longer one, the earlier on ties, if it is not
// further than `max_time_difference` [s]. Nothing is interpolated, and one pose of the longer
// trajectory may serve twice. An error when nothing matches.
std::optional<MatchedPoses> AssociateByStamp(const RecordedTrajectory& reference,
                                             const RecordedTrajectory& estimate,
                                             double max_time_difference,
                                             std::string* error);

// Matches line by line, for formats without stamps. An error when the lengths differ.
std::optional<MatchedPoses> AssociateByIndex(const RecordedTrajectory& reference,
                                             const RecordedTrajectory& estimate,
                                             std::string* error);

// Brings the reference to the stamps of the estimate: between the two poses around a stamp the
// position goes in a straight line and the rotation at a steady rate. Poses of the estimate before
// the first and behind the last pose of the reference, and those between two poses further apart
// than `max_gap` [s], are left out. An error when none is left.
std::optional<MatchedPoses> AssociateInterpolated(const RecordedTrajectory& reference,
                                                  const RecordedTrajectory& estimate,
                                                  double max_gap,
                                                  std::string* error);

}  // namespace radive
