// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/ego_velocity_options.h"

#include "radive/util/number_text.h"

namespace radive {

std::vector<OptionField> EgoVelocityOptions::Fields() {
  return {
      OptionField{"enabled",
                  &enabled,
                  "-",
                  "Whether to fit the velocity of the radar to the Doppler of each scan."},
      OptionField{
          "hypotheses",
          MakeChoice(&hypotheses, {"planar", "spatial"}),
          "-",
          "RANSAC draws velocities from two returns, without a vertical part, or from three "
          "in 3D; planar sensors and Doppler that wraps always take the former."},
      OptionField{
          "fit_gate", &fit_gate, "m/s", "Largest Doppler residual of returns used for the fit."}
          .Above(0.0),
      OptionField{"keep_gate",
                  &keep_gate,
                  "m/s",
                  "Largest Doppler residual of returns that are kept for registration."}
          .Above(0.0),
      OptionField{"sigma_angle",
                  &sigma_angle,
                  "rad",
                  "Noise of the angles in the Doppler equation: widens gate and noise of returns "
                  "across the direction of travel; 0 treats all alike."}
          .AtLeast(0.0),
      OptionField{"temporal_gate",
                  &temporal_gate,
                  "m/s",
                  "Largest change of the horizontal velocity since the last good fit, besides "
                  "max_acceleration; 0: no limit at all."}
          .AtLeast(0.0),
      OptionField{"max_acceleration",
                  &max_acceleration,
                  "m/s^2",
                  "Widens the temporal gate with the time since the last good fit."}
          .AtLeast(0.0),
      OptionField{
          "max_speed",
          &max_speed,
          "m/s",
          "Largest speed that is tried where the Doppler wraps (sensor.doppler_span) and no "
          "earlier velocity tells how often."}
          .Above(0.0)
          .AtMost(200.0),
      OptionField{"num_draws", &num_draws, "-", "Hypotheses of RANSAC for each scan."}
          .AtLeast(1)
          .AtMost(100000),
      OptionField{"seed", &seed, "-", "Seed of the draws."}.AtLeast(0),
      OptionField{"min_inlier_share",
                  &min_inlier_share,
                  "-",
                  "Share of the returns that must agree on a velocity."}
          .AtLeast(0.0)
          .AtMost(1.0),
      OptionField{
          "min_inliers", &min_inliers, "-", "Number of returns that must agree on a velocity."}
          .AtLeast(3),
      OptionField{"max_sigma",
                  &max_sigma,
                  "m/s",
                  "Largest standard deviation of a fit in any horizontal direction."}
          .Above(0.0),
      OptionField{"vertical_ridge",
                  &vertical_ridge,
                  "-",
                  "Draws the vertical velocity to zero with the information of this share of the "
                  "inliers."}
          .AtLeast(0.0),
      OptionField{"vertical_sigma",
                  &vertical_sigma,
                  "m/s",
                  "True size of vertical velocities, for the covariance."}
          .Above(0.0),
      OptionField{"common_sigma",
                  &common_sigma,
                  "m/s",
                  "Standard deviation of the error that all returns of a scan share."}
          .AtLeast(0.0),
      OptionField{"standing_speed",
                  &standing_speed,
                  "m/s",
                  "Below this speed the radar counts as standing."}
          .AtLeast(0.0),
      OptionField{
          "weights", &weights, "-", "Whether returns are weighted by their velocity discrepancy."},
      OptionField{"discrepancy_scale",
                  &discrepancy_scale,
                  "m/s",
                  "Weight of a return: exp(-|Doppler residual| / discrepancy_scale)."}
          .Above(0.0),
  };
}

bool EgoVelocityOptions::IsValid(std::string* error) const {
  if (!CheckOptions("ego_velocity", *this, error)) return false;
  if (!(keep_gate >= fit_gate)) {
    *error = "ego_velocity.keep_gate must be >= ego_velocity.fit_gate, is " +
             NumberText(keep_gate) + " m/s and " + NumberText(fit_gate) + " m/s";
    return false;
  }
  return true;
}

}  // namespace radive
