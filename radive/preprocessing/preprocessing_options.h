// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// Which returns go into the later stages. Angles and ranges are those of the radar frame, after
// calibration.
struct PreprocessingOptions {
  enum class AzimuthBin {
    kOff,
    kExact,      // the paper's: one return for each azimuth bin and elevation, equal but for the
                 // rounding of single-precision coordinates
    kQuantised,  // one return for each azimuth bin and elevation bin
  };

  enum class AzimuthBinOrder {
    kAfterVelocity,   // the ego velocity is fitted to all returns
    kBeforeVelocity,  // ... to those that the bins leave (paper)
  };

  // Field of view; the bounds belong to it.
  double min_range = 1.0;          // [m]
  double max_range = 100.0;        // [m]
  double min_azimuth = -3.1416;    // [rad], positive to the left
  double max_azimuth = 3.1416;     // [rad]
  double min_elevation = -1.5708;  // [rad], positive up
  double max_elevation = 1.5708;   // [rad]

  // Of the returns in one direction only the nearest stays: those behind it have penetrated
  // something or bounced.
  AzimuthBin azimuth_bin = AzimuthBin::kOff;
  AzimuthBinOrder azimuth_bin_order = AzimuthBinOrder::kAfterVelocity;
  double azimuth_bin_width = 0.017453;    // [rad]
  double elevation_bin_width = 0.017453;  // [rad], for kQuantised

  std::vector<OptionField> Fields();

  // True when all fields are in range; otherwise says in `error` which is not, and the rule.
  bool IsValid(std::string* error) const;
};

}  // namespace radive
