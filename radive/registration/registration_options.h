// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/factors/condensed_ndt_cost.h"
#include "radive/ndt/distance_bounded_pairs.h"
#include "radive/util/option_field.h"

namespace radive {

// Options of scan-to-submap registration.
struct RegistrationOptions {
  NdtNormalisation normalisation = NdtNormalisation::kUnit;
  NdtDerivatives derivatives = NdtDerivatives::kAnalytic;

  // Degrees of freedom: a motion in the vehicle's plane (3), or a free one (6). Scans of sensors
  // without elevation are always registered in the plane.
  bool planar = false;

  int num_associations = 2;              // times that pairs are searched
  int max_iterations = 12;               // LM steps after each association
  double step_tolerance = 1e-4;          // a step shorter than this ends it [m and rad together]
  double initial_lm_lambda = 1e-4;       // of H + lambda diag(H)
  int min_gaussians = 10;                // fewer in the scan: not registered
  double max_correction = 3.0;           // largest believable distance from the prediction [m]
  double max_rotation_correction = 0.2;  // [rad]

  // A direction is degenerate when the scan alone leaves more than this standard deviation in it.
  double degenerate_translation = 0.5;  // [m]
  double degenerate_rotation = 0.05;    // [rad]

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("registration", *this, error); }
};

}  // namespace radive
