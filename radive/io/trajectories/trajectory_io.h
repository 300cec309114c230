// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "radive/sensor/recorded_trajectory.h"
#include "radive/sensor/trajectory.h"

namespace radive {

// Text files of poses T_world_body, one pose a line:
//
//   kTum    t x y z qx qy qz qw                          t in seconds
//   kKitti  r00 r01 r02 x r10 r11 r12 y r20 r21 r22 z    no stamps
//   kEuroc  t x y z qw qx qy qz, further columns ignored t in nanoseconds
enum class TrajectoryFormat { kTum, kKitti, kEuroc };

// Reads such a file. Lenient about form: numbers are separated by blanks, tabs or commas, empty
// lines, lines that start with '#', a first line without any number (names of the columns),
// carriage returns and a byte order mark are skipped, and a TUM stamp of more than 15 digits
// without a point counts nanoseconds. Strict about content: a line with a missing or superfluous
// number, a non-number or a non-finite one is an error, and so is a file without poses. `error`
// then says "FILE:LINE: what was expected, what was found".
//
// As in evo, quaternions are normalised (a zero quaternion counts as identity) and the rotation
// matrices of KITTI files are taken as they are. Lines keep their order; stamps need not ascend.
std::optional<RecordedTrajectory> ReadTrajectory(const std::filesystem::path& file,
                                                 TrajectoryFormat format,
                                                 std::string* error);

// The same with the text of a file; `place` stands for its name in messages.
std::optional<RecordedTrajectory> ParseTrajectory(std::string_view text,
                                                  TrajectoryFormat format,
                                                  const std::string& place,
                                                  std::string* error);

// One line of a TUM or KITTI file, without the line end: single blanks, nine decimals, as evo
// accepts it. For writers that add poses as they come.
std::string TumLine(const StampedPose& pose);
std::string KittiLine(const StampedPose& pose);

// Writes a whole file. It appears complete under its name or not at all: the text goes to
// FILE.part first. False, with `error`, when that fails.
bool WriteTumTrajectory(const std::filesystem::path& file,
                        const Trajectory& trajectory,
                        std::string* error);

}  // namespace radive
