// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/motion_options.h"

namespace radive {

std::vector<OptionField> MotionOptions::Fields() {
  return {
      {"body",
       MakeChoice(&body, {"radar", "vehicle"}),
       "-",
       "Whose pose the trajectory is of: the radar's (of the first scan), or the vehicle's, by "
       "sensor.mount_* or sensor.mounts."},
      {"doppler_prior",
       &doppler_prior,
       "-",
       "Hold the translation that the ego velocity predicts, by the velocity's covariance."},
      OptionField{"doppler_floor",
                  &doppler_floor,
                  "m/s",
                  "Standard deviation added to the ego velocity's own, for its slow errors."}
          .Above(0.0),
      OptionField{"low_speed_lambda",
                  &low_speed_lambda,
                  "1/m^2",
                  "Weight of the paper's translation prior at low speed; 0 turns it off."}
          .AtLeast(0.0),
      OptionField{"low_speed_limit",
                  &low_speed_limit,
                  "m/s",
                  "Speed below which the paper's translation prior acts."}
          .AtLeast(0.0),
      OptionField{"rotation_sigma_rate",
                  &rotation_sigma_rate,
                  "rad/s",
                  "Standard deviation of a rotation prior at the last turning rate; 0 turns it "
                  "off."}
          .AtLeast(0.0),
      {"no_slip",
       &no_slip,
       "-",
       "Prior of a road vehicle: the rear axle moves where it points (needs sensor.mount_*)."},
      OptionField{"no_slip_sigma",
                  &no_slip_sigma,
                  "m/s",
                  "Standard deviation of the rear axle's lateral velocity."}
          .AtLeast(0.0),
      OptionField{"no_slip_floor",
                  &no_slip_floor,
                  "m",
                  "Standard deviation of its lateral displacement between two scans, besides."}
          .Above(0.0),
      OptionField{"slip_sigma",
                  &slip_sigma,
                  "rad",
                  "Size of the slip angle that is followed online (road bank, mounting error)."}
          .Above(0.0),
      OptionField{"slip_time", &slip_time, "s", "Correlation time of that slip angle."}.Above(0.0),
      OptionField{"slip_compliance",
                  &slip_compliance,
                  "rad s^2/m",
                  "Drift angle of the rear axle for each m/s^2 of lateral acceleration."}
          .AtLeast(0.0),
      OptionField{"attitude_sigma",
                  &attitude_sigma,
                  "rad",
                  "Standard deviation of roll and pitch about the vehicle's axis; 0 turns it off."}
          .AtLeast(0.0),
      OptionField{"height_sigma",
                  &height_sigma,
                  "m",
                  "Standard deviation of the height, with attitude_sigma."}
          .AtLeast(0.0),
      OptionField{"gap_slack_rate",
                  &gap_slack_rate,
                  "m/s",
                  "Widening of pairs.slack with time since the last registered scan."}
          .AtLeast(0.0),
      OptionField{"restart_time",
                  &restart_time,
                  "s",
                  "Time without registration after which keyframes are added at predicted poses."}
          .AtLeast(0.0),
      OptionField{"innovation_gate",
                  &innovation_gate,
                  "-",
                  "A scan registered further from its prediction than so many times the median of "
                  "the scans before is taken as badly registered; 0 turns it off."}
          .AtLeast(0.0),
  };
}

}  // namespace radive
