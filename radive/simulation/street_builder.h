// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "radive/simulation/radar_world.h"
#include "radive/simulation/street_path.h"

namespace radive {

// Builds the street around `path`, generated from `seed`: rows of facades with bays and gaps on
// both sides, side streets that go on straight at every corner, poles, parked cars, taller
// buildings behind, and one stretch of about 100 m without facades. Nothing stands on the
// driving lane (y = 0 of a side) or on the oncoming lane (y = 4 m).
RadarWorld BuildStreet(const StreetPath& path, std::uint64_t seed);

}  // namespace radive
