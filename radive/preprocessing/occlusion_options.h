// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// Which returns count as occluded: seen through, or mirrored in, something nearer. A mirror image
// in a curved wall does not move like the street, and its Doppler nearly fits, so that no gate on
// the Doppler removes it.
struct OcclusionOptions {
  bool enabled = false;

  // A static return hides another when it lies within `azimuth` of it, nearer by `range_gap` and
  // nearer than `range_ratio` of its range.
  double azimuth = 0.0524;   // [rad]
  double range_ratio = 0.6;  // [-]
  double range_gap = 3.0;    // [m]

  // Returns hidden by more than this many do not enter registration.
  int max_count = 4;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("occlusion", *this, error); }
};

}  // namespace radive
