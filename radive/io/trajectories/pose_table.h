// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// Which column of a text table of poses holds what, from 0; -1: there is none.
struct PoseColumns {
  int stamp = -1;
  int stamp_exponent = 0;  // the stamp counts units of 10^stamp_exponent s: -6 for microseconds
  std::array<int, 3> position = {-1, -1, -1};        // x y z [m]; without z it is 0
  std::array<int, 4> quaternion = {-1, -1, -1, -1};  // x y z w
  std::array<int, 3> angles = {-1, -1, -1};          // roll pitch yaw [rad], where no quaternion is

  // The angles are those of the world seen from the body, as in Boreas: the rotation is
  // Rx(-roll) Ry(-pitch) Rz(-yaw) instead of Rz(yaw) Ry(pitch) Rx(roll).
  bool angles_are_passive = false;

  // The first line with anything in it holds the names of the columns.
  bool has_names = false;
};

// Ground truth of RadarScenes in the tables radarK_scans.csv: timestamp_odom, x, y and yaw, pose of
// the car (origin at the rear axle). Nothing when the line of names lacks one of them.
std::optional<PoseColumns> RadarScenesColumns(std::string_view names);

// Boreas, applanix/*_poses.csv: t [us], x y z in ENU, three velocities, roll, pitch, yaw and more.
PoseColumns BoreasColumns();

// ColoRadar, groundtruth_poses.txt: x y z qx qy qz qw, without stamps.
PoseColumns ColoRadarColumns();

// A table with more columns than a TUM file, such as ref_tls_T_xt32.csv of SNAIL-Radar: by the
// names in its first line, if it has any: a stamp (timestamp, time, t ...), x y z (also tx, px,
// p_x ...) and qx qy qz qw. Otherwise by its numbers: the first column is the stamp, then come
// x y z, and the quaternion x y z w is the first four columns in a row behind them that have length
// 1 in all lines. Nothing, with the reason in `error`, when that does not tell.
std::optional<PoseColumns> FindPoseColumns(std::string_view text,
                                           const std::string& place,
                                           std::string* error);

// Reads such a table: columns are separated by blanks, tabs, commas or semicolons; empty lines and
// those that start with '#' are left out; stamps of more than 15 digits without a point are
// nanoseconds. False, with "PLACE:LINE: what was expected, what was found" in `error`, when a line
// has not all the columns or one of them is no finite number, and when there are no poses.
bool ParsePoseTable(std::string_view text,
                    const PoseColumns& columns,
                    const std::string& place,
                    RecordedTrajectory* poses,
                    std::string* error);

}  // namespace radive
