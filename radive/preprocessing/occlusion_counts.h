// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/preprocessing/occlusion_options.h"

namespace radive {

// For each return the number of those that hide it (OcclusionOptions). `azimuths` [rad] and
// `ranges` [m] are the returns; only those with `can_hide` hide others. O(n log n) plus the pairs
// that share a window of azimuth; azimuths do not wrap around, as no radar looks all around.
std::vector<int> OcclusionCounts(const std::vector<double>& azimuths,
                                 const std::vector<double>& ranges,
                                 const std::vector<bool>& can_hide,
                                 const OcclusionOptions& options);

}  // namespace radive
