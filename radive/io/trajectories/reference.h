// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/trajectories/pose_table.h"
#include "radive/io/trajectories/trajectory_io.h"
#include "radive/sensor/recorded_trajectory.h"

namespace radive {

// The ground truth of a drive.
struct Reference {
  RecordedTrajectory poses;           // T_world_reference; the world is whatever the dataset chose
  bool has_stamps = true;             // false: a pose for each scan, in their order
  bool has_rotations = true;          // false: places alone
  std::string description;            // what was found: "TUM trajectory in FILE"
  std::vector<std::string> warnings;  // what is odd about the poses, see check_poses.h
};

// Takes over the poses; false when there are none.
bool SetPoses(std::optional<RecordedTrajectory> poses, bool has_stamps, Reference* reference);

// Reads poses and has_stamps of a file of that form. False, with place and expectation in `error`,
// when that fails.
bool ReadReferenceText(const std::filesystem::path& file,
                       TrajectoryFormat format,
                       Reference* reference,
                       std::string* error);

// The same for a table; without `columns` they are found out, see FindPoseColumns().
bool ReadReferenceTable(const std::filesystem::path& file,
                        const std::optional<PoseColumns>& columns,
                        Reference* reference,
                        std::string* error);

}  // namespace radive
