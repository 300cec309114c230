// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "radive/io/trajectories/reference_options.h"
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

// Reads the ground truth at `path`: a file, or a folder in which it lies where its dataset puts it.
// With format auto a file is known by its name or by the number of columns in its first line, a
// folder by what it holds. `clip`: of RaFlow, see InputOptions::clip. `options` must be valid.
// Nothing, with the place, what was found and what was expected in `error`, when that fails.
std::optional<Reference> ReadReference(const std::filesystem::path& path,
                                       const ReferenceOptions& options,
                                       int clip,
                                       std::string* error);

}  // namespace radive
