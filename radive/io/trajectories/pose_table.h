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
  bool has_stamp_unit = false;  // stamp_exponent is said by the file: 0 is seconds for sure
  int nanoseconds = -1;         // added to a stamp of whole seconds
  std::array<int, 3> position = {-1, -1, -1};        // x y z [m]; without z it is 0
  std::array<int, 4> quaternion = {-1, -1, -1, -1};  // x y z w
  std::array<int, 3> angles = {-1, -1, -1};          // roll pitch yaw, where no quaternion is
  double angle_unit = 1.0;                           // [rad]

  // Rows of [R | t], instead of position and rotation. R is taken as it is.
  std::array<int, 12> matrix = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};

  // The angles are those of the world seen from the body, as in Boreas: the rotation is
  // Rx(-roll) Ry(-pitch) Rz(-yaw) instead of Rz(yaw) Ry(pitch) Rx(roll).
  bool angles_are_passive = false;

  // What separates the columns: ';' or ' ' (any blanks), where commas are decimal commas; 0:
  // blanks, tabs, commas and semicolons alike.
  char delimiter = '\0';

  // The first line with anything in it holds the names of the columns.
  bool has_names = false;
};

// The columns of a line as `delimiter` of PoseColumns says, decimal commas made points.
std::vector<std::string> SplitPoseLine(std::string_view line, char delimiter);

// Reads such a table: empty lines and those that start with # or % are left out; stamps of more
// than 15 digits without a point are nanoseconds. False, with "PLACE:LINE: what was expected, what
// was found" in `error`, when a line has not all the columns or one of them is no finite number,
// and when there are no poses.
bool ParsePoseTable(std::string_view text,
                    const PoseColumns& columns,
                    const std::string& place,
                    RecordedTrajectory* poses,
                    std::string* error);

}  // namespace radive
