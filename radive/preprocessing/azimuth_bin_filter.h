// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/preprocessing/preprocessing_options.h"
#include "radive/sensor/radar_scan.h"

namespace radive {

// Azimuth-bin filtering (paper, preprocessing section): of the returns with the same azimuth bin
//
//   b = floor((azimuth + pi) / azimuth_bin_width),  b in {0, ..., B - 1}
//
// and the same elevation e the nearest one stays, the first in order when ranges are equal. As
// printed, e is the measured elevation itself (kExact): two returns then fall together only on
// sensors with gridded elevation, planar ones among them. With kQuantised e is an elevation bin.
//
// Keeps the order of the returns. Positions must be finite. Time and memory O(n).
std::vector<RadarReturn> FilterAzimuthBins(const std::vector<RadarReturn>& returns,
                                           const PreprocessingOptions& options);

}  // namespace radive
