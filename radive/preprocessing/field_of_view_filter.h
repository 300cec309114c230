// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/preprocessing/preprocessing_options.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// Whether a position in the radar frame [m] lies in the field of view, edges included. False for
// positions that are not finite.
bool InFieldOfView(const Eigen::Vector3d& p_radar, const PreprocessingOptions& options);

// Whether it lies within the ranges alone, whatever its angles.
bool InRange(const Eigen::Vector3d& p_radar, const PreprocessingOptions& options);

// The returns in the field of view, in their order.
std::vector<RadarReturn> GateFieldOfView(const std::vector<RadarReturn>& returns,
                                         const PreprocessingOptions& options);

}  // namespace radive
