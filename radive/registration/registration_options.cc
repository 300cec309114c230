// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/registration/registration_options.h"

namespace radive {

std::vector<OptionField> RegistrationOptions::Fields() {
  return {
      {"method",
       MakeChoice(&method, {"ndt", "full_ndt", "gicp", "plane_icp", "icp", "doppler_icp"}),
       "-",
       "How scan and submap are compared: NDT with bounded or all pairs, or nearest neighbours by "
       "surface, plane, point, or plane and Doppler."},
      {"normalisation",
       MakeChoice(&normalisation, {"paper", "unit"}),
       "-",
       "Height of a pair's Gaussian in the cost: paper divides by sqrt((2 pi)^3 |Sigma|), unit "
       "gives every pair the same."},
      {"derivatives",
       MakeChoice(&derivatives, {"analytic", "autodiff"}),
       "-",
       "How the condensed block forms its derivatives; autodiff is the slow reference."},
      {"planar", &planar, "-", "Estimate a motion in the vehicle's plane only (3 DoF)."},
      OptionField{"num_associations",
                  &num_associations,
                  "-",
                  "Times that pairs are searched; not again where the scan hardly moved."}
          .AtLeast(1),
      OptionField{"max_iterations", &max_iterations, "-", "LM steps after each association."}
          .AtLeast(1),
      OptionField{"step_tolerance", &step_tolerance, "m, rad", "A shorter step ends the solve."}
          .Above(0.0),
      OptionField{
          "step_deviations",
          &step_deviations,
          "-",
          "A step of fewer standard deviations of the pose, as the cost's curvature has them, is "
          "the last one; where other pairs are likely, one of five times as many; 0: never."}
          .AtLeast(0.0),
      OptionField{"initial_lm_lambda", &initial_lm_lambda, "-", "First damping of LM."}.Above(0.0),
      OptionField{"min_gaussians", &min_gaussians, "-", "Scans with fewer are not registered."}
          .AtLeast(1),
      OptionField{"max_correction",
                  &max_correction,
                  "m",
                  "A result further from the prediction is rejected."}
          .Above(0.0),
      OptionField{"max_rotation_correction",
                  &max_rotation_correction,
                  "rad",
                  "A result turned further from the prediction is rejected."}
          .Above(0.0),
      OptionField{"degenerate_translation",
                  &degenerate_translation,
                  "m",
                  "Standard deviation from which a direction counts as unobserved."}
          .Above(0.0),
      OptionField{"degenerate_rotation",
                  &degenerate_rotation,
                  "rad",
                  "Standard deviation from which a rotation counts as unobserved."}
          .Above(0.0),
      OptionField{"icp_sigma",
                  &icp_sigma,
                  "m",
                  "ICP methods: standard deviation of a scan point from its point or surface."}
          .Above(0.0),
      OptionField{
          "icp_neighbors", &icp_neighbors, "-", "ICP methods: points that a surface is fitted to."}
          .AtLeast(3)
          .AtMost(100),
  };
}

}  // namespace radive
