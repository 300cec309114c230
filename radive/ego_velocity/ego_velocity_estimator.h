// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "radive/ego_velocity/ego_velocity.h"
#include "radive/ego_velocity/ego_velocity_options.h"
#include "radive/ego_velocity/velocity_ransac.h"
#include "radive/preprocessing/occlusion_options.h"
#include "radive/sensor/radar_scan.h"
#include "radive/sensor/sensor_options.h"
#include "radive/util/recent_median.h"

namespace radive {

// Velocity of the radar, scan by scan: RANSAC over hypotheses from two or three returns
// (EgoVelocityOptions::hypotheses), gated by the last good velocity, then least squares over the
// returns within the fit gate (paper, preprocessing section; DopplerFactor), gated anew for each
// round. With occlusion weights the fit is done once more, in which returns behind others count
// less. Where the Doppler wraps (SensorOptions::doppler_span), the multiple of the span is that
// nearest to the velocity at hand, which DrawVelocityBranch() finds.
//
// Deterministic: the draws depend on the seed and on the number of scans so far.
class EgoVelocityEstimator {
 public:
  // The options must be valid.
  EgoVelocityEstimator(const EgoVelocityOptions& options,
                       const SensorOptions& sensor,
                       const OcclusionOptions& occlusion = OcclusionOptions());

  // The velocity at one scan. Returns that are not finite, lie at the origin or have no Doppler
  // take no part. `is_planar`: the sensor measures no elevation; v_z is then zero along the
  // sensor's own z axis. Never fails: see EgoVelocity::reason.
  EgoVelocity Estimate(const std::vector<RadarReturn>& returns,
                       bool is_planar,
                       std::int64_t stamp_ns);

 private:
  struct LastGood {
    Eigen::Vector3d v_radar;     // [m/s]
    Eigen::Matrix3d covariance;  // [m^2/s^2]
    std::int64_t stamp_ns;
  };

  struct Refined {
    EgoVelocity fit;
    Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();  // sum of d d^T over the inliers
  };

  // Holds a velocity against the last one as far as velocities have changed of late: empty, or why
  // it is not believed. RANSAC's gate is wide, for what a fit may start from.
  std::string WhyContradictory(const DopplerEquations& equations,
                               const Eigen::Vector3d& v_radar,
                               std::int64_t stamp_ns);
  double SecondsSinceLastGood(std::int64_t stamp_ns) const;
  std::optional<VelocityGate> TemporalGate(const DopplerEquations& equations,
                                           std::int64_t stamp_ns) const;
  EgoVelocity Fit(const DopplerEquations& equations,
                  const Eigen::Vector3d& up_radar,
                  const std::optional<VelocityGate>& temporal_gate,
                  double vertical_ridge,
                  bool is_planar);
  std::optional<Eigen::Vector3d> Draw(const DopplerEquations& equations,
                                      const std::optional<VelocityGate>& temporal_gate,
                                      bool is_planar,
                                      Random* random,
                                      std::string* reason) const;
  Refined Refine(const DopplerEquations& equations,
                 const Eigen::Vector3d& up_radar,
                 const Eigen::Vector3d& v_start,
                 const Eigen::ArrayXd& weights,
                 double vertical_ridge) const;
  // Weights of the returns, of mean square 1 or less: those behind others count less.
  Eigen::ArrayXd OcclusionWeights(const DopplerEquations& equations,
                                  const Eigen::Vector3d& v_radar) const;
  double NoiseRatio() const { return options_.sigma_angle / sensor_.sigma_doppler; }
  Eigen::Vector3d LeastSquares(const DopplerSums& sums,
                               const Eigen::Vector3d& up_radar,
                               const Eigen::Vector3d& v_start,
                               double vertical_ridge) const;
  Eigen::Matrix3d Covariance(const DopplerSums& sums,
                             const Eigen::Vector3d& up_radar,
                             double vertical_ridge) const;
  double HorizontalSigma(const Refined& refined, const DopplerEquations& equations) const;
  std::string WhyUnusable(const Refined& refined,
                          const DopplerEquations& equations,
                          const std::optional<VelocityGate>& temporal_gate) const;

  const EgoVelocityOptions options_;
  const SensorOptions sensor_;
  const OcclusionOptions occlusion_;
  const Eigen::Vector3d up_radar_;       // of the vehicle, unit
  const Eigen::Vector3d forward_radar_;  // of the vehicle, unit
  std::uint64_t num_scans_ = 0;
  std::optional<LastGood> last_good_;
  RecentMedian changes_;  // of the horizontal velocity between scans [m/s]
};

}  // namespace radive
