// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/velocity_discrepancy.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "radive/sensor/doppler_wrap.h"

namespace radive {

namespace {

inline double Discrepancy(const RadarReturn& entry, const Eigen::Vector3d& v_radar, double span) {
  const double range = entry.position.norm();
  const double difference = -entry.position.dot(v_radar) / range - entry.doppler;
  // No number where one of them is none; a range that is not finite may give any.
  if (!std::isfinite(difference) || !std::isfinite(range)) {
    return std::numeric_limits<double>::infinity();
  }
  return std::abs(WrapDoppler(difference, span));
}

}  // namespace

double VelocityDiscrepancy(const RadarReturn& entry, const Eigen::Vector3d& v_radar, double span) {
  return Discrepancy(entry, v_radar, span);
}

double DiscrepancyNoiseScale(const RadarReturn& entry,
                             const Eigen::Vector3d& v_radar,
                             double ratio) {
  if (ratio == 0.0) return 1.0;
  const double across = entry.position.cross(v_radar).norm() / entry.position.norm();
  return std::hypot(1.0, across * ratio);
}

std::vector<double> DiscrepancyWeights(const std::vector<RadarReturn>& returns,
                                       const Eigen::Vector3d& v_radar,
                                       double scale,
                                       double span) {
  CHECK_GT(scale, 0.0);
  std::vector<double> weights;
  weights.reserve(returns.size());
  for (const RadarReturn& entry : returns) {
    weights.push_back(std::exp(-Discrepancy(entry, v_radar, span) / scale));
  }
  return weights;
}

std::vector<bool> KeepMask(const std::vector<RadarReturn>& returns,
                           const Eigen::Vector3d& v_radar,
                           double keep_gate,
                           double noise_ratio,
                           double span) {
  std::vector<bool> mask;
  mask.reserve(returns.size());
  for (const RadarReturn& entry : returns) {
    mask.push_back(Discrepancy(entry, v_radar, span) <=
                   keep_gate * DiscrepancyNoiseScale(entry, v_radar, noise_ratio));
  }
  return mask;
}

}  // namespace radive
