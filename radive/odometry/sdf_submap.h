// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "radive/odometry/odometry_options.h"
#include "radive/odometry/submap.h"

namespace radive {

// A submap of the surface that the neural map has learned (paper, section "Surface Point
// Extraction"). Keyframes are trained on their own thread while the next scans are registered, with
// options.num_threads > 1; what a scan is registered against depends on scan indices alone.
std::unique_ptr<Submap> MakeSdfSubmap(const OdometryOptions& options);

}  // namespace radive
