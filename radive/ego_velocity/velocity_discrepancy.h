// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "radive/sensor/radar_scan.h"

namespace radive {

// |v_prop - v_doppler| of a return [m/s], with v_prop = -d . v_radar: what its Doppler differs from
// that of a static return. Infinite when the return has no direction or no Doppler. `span`: of a
// Doppler that is known but for multiples of it [m/s], see SensorOptions::doppler_span; the nearest
// counts.
double VelocityDiscrepancy(const RadarReturn& entry,
                           const Eigen::Vector3d& v_radar,
                           double span = 0.0);

// Growth of the gate on the discrepancy with the noise of the angles, see
// EgoVelocityOptions::sigma_angle. `ratio`: sigma_angle over sigma_doppler [s/m].
double DiscrepancyNoiseScale(const RadarReturn& entry,
                             const Eigen::Vector3d& v_radar,
                             double ratio);

// Reliability of each return (paper, velocity-discrepancy section): w = exp(-|dv| / scale), in
// (0, 1]; 0 for returns without direction or Doppler. v_radar and scale in m/s, scale > 0.
std::vector<double> DiscrepancyWeights(const std::vector<RadarReturn>& returns,
                                       const Eigen::Vector3d& v_radar,
                                       double scale,
                                       double span = 0.0);

// Whether each return is within keep_gate [m/s] of a static one.
std::vector<bool> KeepMask(const std::vector<RadarReturn>& returns,
                           const Eigen::Vector3d& v_radar,
                           double keep_gate,
                           double noise_ratio = 0.0,
                           double span = 0.0);

}  // namespace radive
