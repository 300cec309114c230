// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "radive/simulation/simulation_options.h"

namespace radive {

// The named scenarios, each PLACE_SENSOR:
//
//   street       a town, 12 m/s                     dense   4D radar of thousands of returns
//   avenue       a wide road out of town, 17 m/s    sparse  4D radar of 150 returns
//   campus       single buildings on slopes         planar  corner radar without elevation
//   car_park     rows of parked cars, 4 m/s         aeva    FMCW lidar
//   tunnel       bare walls and a roof
//   stop_and_go  a street behind a truck that owns most returns
//   handcart     rocking along the car park at less than 1.5 m/s
//   outages      a street with seconds without scans
const std::vector<std::string>& ScenarioNames();

// Options of a scenario, two minutes long; nothing when there is no such name.
std::optional<SimulationOptions> ScenarioOptions(const std::string& name);

}  // namespace radive
