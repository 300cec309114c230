// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radive/evaluation/association.h"

namespace radive {

// Error of the estimated motion along one segment of the reference path.
struct SegmentError {
  int first_pose = 0;        // index of the matched pose that starts the segment
  double length = 0.0;       // nominal length [m]: 100, 200, ... 800
  double translation = 0.0;  // error per length [-]
  double rotation = 0.0;     // error per length [rad/m]
};

struct SegmentDrift {
  std::vector<SegmentError> segments;  // by start, then by length; never empty
  double translation = 0.0;            // mean over all segments [-]
  double rotation = 0.0;               // mean over all segments [rad/m]
};

// Segment errors of the KITTI odometry benchmark: segments of 100, 200, ... 800 m start at every
// `step`-th matched pose (10 in the benchmark) and end at the first pose that is further along
// the reference than that; a segment that the reference does not complete is left out.
// An error when there is none at all. `step` >= 1 (checked).
std::optional<SegmentDrift> ComputeSegmentDrift(const MatchedPoses& poses,
                                                int step,
                                                std::string* error);

}  // namespace radive
