// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "radive/io/trajectories/pose_table.h"

namespace radive {

// The names in a line, one for each column: separated by semicolons, commas or tabs, otherwise by
// blanks, where a unit in brackets belongs to the name before.
std::vector<std::string_view> SplitNames(std::string_view line);

// What columns of these names hold, see FindPoseColumns(). Nothing unless there are a position and
// a rotation.
std::optional<PoseColumns> ColumnsByName(const std::vector<std::string_view>& names);

}  // namespace radive
