// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <optional>

#include "radive/sensor/radar_scan.h"
#include "radive/sensor/sensor_options.h"

namespace radive {

// Below this a radar stands by its Doppler [m/s].
inline constexpr double kStandingSpeed = 0.3;

// What the Doppler of one scan says by itself, in whatever unit it is.
struct DopplerFit {
  double share_with_doppler = 0.0;  // of the returns: those that have a number for it [-]
  int num_returns = 0;              // with Doppler, of those that were looked at
  int num_inliers = 0;              // that agree on one velocity
  int num_by_chance = 0;  // that agree on one when the Doppler is dealt out anew among the returns

  // Of the radar in the radar frame; none when too few returns agree. `v_minus`: with the Doppler
  // turned, which is -v_plus but where the Doppler wraps.
  std::optional<Eigen::Vector3d> v_plus;
  std::optional<Eigen::Vector3d> v_minus;
};

// Looks at some hundred returns at most. The noise may be that of Doppler in any unit: beyond the
// speeds of cars the gates grow with the Doppler. Of `sensor`, which is this radar's, only what a
// Doppler that wraps needs is looked at: its span, and where the front of the vehicle is.
DopplerFit FitDoppler(const RadarScan& scan, const SensorOptions& sensor);

}  // namespace radive
