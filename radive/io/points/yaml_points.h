// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "radive/io/points/point_table.h"

namespace radive {

// Takes a message printed as YAML apart whose points are a block list of flat maps, as ros2 topic
// echo and the tests of Nebula have it:
//
//   detections:
//     - azimuth_angle: -0.918583
//       range: 3.37381
//     - azimuth_angle: ...
//
// The fields are the keys of the first point, as float64; true is 1, false 0, what is absent or no
// number is NaN. Nothing else of YAML is understood; what stands before the list is left out.
//
// False, with the expectation in `error`, when there is no such list.
bool ParseYamlPoints(std::string_view text,
                     PointTable* table,
                     std::vector<std::string>* remarks,
                     std::string* error);

}  // namespace radive
