// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "radive/simulation/radar_world.h"
#include "radive/simulation/street_path.h"
#include "radive/simulation/world_style.h"

namespace radive {

// Builds the world around `path` in the given style, generated from `seed`. Nothing stands on the
// driving lane (y = 0 of a side) or on the oncoming lane (y = 4 m).
RadarWorld BuildWorld(const StreetPath& path, const WorldStyle& style, std::uint64_t seed);

}  // namespace radive
