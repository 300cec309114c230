// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// False, with what was expected and what was found in `problem`, for numbers that are no pose: a
// position beyond 1e9 m, a quaternion (other than zero) whose length is not within 0.5 .. 2, and a
// matrix R with ||R R^T - I|| >= 0.05 or a determinant that is not positive.
bool CheckPose(const RecordedPose& pose, std::string* problem);

// Calls it for all poses; `error` begins with "PLACE: pose NUMBER: ", numbers count from 1.
bool CheckPoses(const RecordedTrajectory& poses, const std::string& place, std::string* error);

// Finds numbers with a decimal comma: at least half of the words of the line, which blanks or
// semicolons separate, look like 27,516 and none has a point. True, with the first of them in
// `problem`.
bool HasDecimalCommas(std::string_view line, std::string* problem);

// What is odd about the poses of `place`, each doubt a line, with how many poses it concerns:
// quaternions of length zero or more than 1 % off 1, matrices with ||R R^T - I|| > 1e-3, stamps
// that go back, quaternions that seem to be written as qw qx qy qz, and spikes. A spike is a
// position (or rotation) off the interpolation of both neighbours by more than 0.5 m (0.35 rad) and
// twenty times the median, which takes more than 30 m/s^2 (30 rad/s^2). Without stamps poses are
// taken as evenly spaced, at an unknown rate.
std::vector<std::string> DoubtsAboutPoses(const RecordedTrajectory& poses,
                                          bool has_stamps,
                                          bool has_rotations,
                                          const std::string& place);

}  // namespace radive
