// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/factors/ndt_cost_options.h"
#include "radive/ndt/distance_bounded_pairs.h"
#include "radive/util/option_field.h"

namespace radive {

// How a scan is aligned with the submap. All have the same inputs, priors, steps and loss.
enum class RegistrationMethod {
  kNdt,      // distance-bounded NDT
  kFullNdt,  // NDT with all pairs
  kGicp,     // plane to plane
  kPlaneIcp,
  kIcp,         // point to point
  kDopplerIcp,  // point to plane and range rates
};

// Options of scan-to-submap registration.
struct RegistrationOptions {
  RegistrationMethod method = RegistrationMethod::kNdt;
  NdtNormalisation normalisation = NdtNormalisation::kUnit;
  NdtDerivatives derivatives = NdtDerivatives::kAnalytic;

  // Degrees of freedom: a motion in the vehicle's plane (3), or a free one (6). Scans of sensors
  // without elevation are always registered in the plane.
  bool planar = false;

  int num_associations = 2;              // times that pairs are searched; ICP: every step
  int max_iterations = 12;               // LM steps after each association
  double step_tolerance = 1e-4;          // a step shorter than this ends it [m and rad together]
  double step_deviations = 0.1;          // as does one of so many standard deviations [-]
  double initial_lm_lambda = 1e-4;       // of H + lambda diag(H)
  int min_gaussians = 10;                // fewer in the scan: not registered
  double max_correction = 3.0;           // largest believable distance from the prediction [m]
  double max_rotation_correction = 0.2;  // [rad]

  // A direction is degenerate when the scan alone leaves more than this standard deviation in it.
  double degenerate_translation = 0.5;  // [m]
  double degenerate_rotation = 0.05;    // [rad]

  // Of the ICP family.
  double icp_sigma = 0.5;  // distance of a scan point from its point or surface [m]
  int icp_neighbors = 10;  // that a surface is fitted to

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("registration", *this, error); }
};

}  // namespace radive
