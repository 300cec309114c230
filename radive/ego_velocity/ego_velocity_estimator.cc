// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/ego_velocity_estimator.h"

#include <ceres/problem.h>
#include <glog/logging.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "radive/factors/condensed_doppler_factor.h"
#include "radive/factors/doppler_factor.h"
#include "radive/solver/solve.h"
#include "radive/util/random.h"

namespace radive {
namespace {

constexpr int kMaxRounds = 6;

// The noise that the covariance assumes starts from sigma_doppler, worth this many returns, so that
// a handful of inliers that agree by chance does not claim to be exact.
constexpr double kPriorReturns = 10.0;

// Smallest slope of the estimating equation, see Covariance().
constexpr double kMinSlope = 0.3;

// Lets the ridge stand for "nothing known" where the returns leave the vertical open.
constexpr double kMinRidge = 1e-6;

std::vector<Eigen::Index> WithinGate(const Eigen::ArrayXd& residuals, double gate) {
  std::vector<Eigen::Index> inliers;
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    if (std::abs(residuals[i]) <= gate) inliers.push_back(i);
  }
  return inliers;
}

std::string Format(const char* format, double a, double b, double c) {
  char text[160];
  std::snprintf(text, sizeof(text), format, a, b, c);
  return text;
}

}  // namespace

EgoVelocityEstimator::EgoVelocityEstimator(const EgoVelocityOptions& options,
                                           const SensorOptions& sensor)
    : options_(options),
      sensor_(sensor),
      up_radar_(sensor.T_vehicle_radar().rotation.conjugate() * Eigen::Vector3d::UnitZ()) {
  std::string error;
  CHECK(options_.IsValid(&error)) << error;
  CHECK(sensor_.IsValid(&error)) << error;
  // The problem is linear: one undamped step solves it.
  solver_options_.initial_trust_region_radius = 1e16;
  solver_options_.max_iterations = 5;
}

EgoVelocity EgoVelocityEstimator::Estimate(const std::vector<RadarReturn>& returns,
                                           bool is_planar,
                                           std::int64_t stamp_ns) {
  ++num_scans_;
  // A planar sensor sees the velocity in its own plane, however it is mounted.
  const Eigen::Vector3d up_radar = is_planar ? Eigen::Vector3d::UnitZ() : up_radar_;
  const double ridge = is_planar ? 1.0 : std::max(options_.vertical_ridge, kMinRidge);
  const DopplerEquations equations = MakeDopplerEquations(returns, up_radar);
  const std::optional<VelocityGate> gate = TemporalGate(equations, stamp_ns);

  EgoVelocity result = Fit(equations, up_radar, gate, ridge);
  result.num_returns = equations.size();
  result.valid = result.reason.empty();
  if (result.valid) {
    const double speed = (equations.basis.transpose() * result.v_radar).norm();
    result.is_standing = speed < options_.standing_speed;
    last_good_ = LastGood{result.v_radar, result.covariance, stamp_ns};
  } else if (last_good_) {
    const double change = options_.max_acceleration * SecondsSinceLastGood(stamp_ns);
    result.v_radar = last_good_->v_radar;
    result.covariance = last_good_->covariance + change * change * Eigen::Matrix3d::Identity();
  } else {
    result.v_radar.setZero();
    result.covariance.setZero();
  }
  return result;
}

double EgoVelocityEstimator::SecondsSinceLastGood(std::int64_t stamp_ns) const {
  return std::max(0.0, 1e-9 * static_cast<double>(stamp_ns - last_good_->stamp_ns));
}

std::optional<VelocityGate> EgoVelocityEstimator::TemporalGate(const DopplerEquations& equations,
                                                               std::int64_t stamp_ns) const {
  if (!last_good_ || options_.temporal_gate == 0.0) return std::nullopt;
  return VelocityGate{
      equations.basis.transpose() * last_good_->v_radar,
      options_.temporal_gate + options_.max_acceleration * SecondsSinceLastGood(stamp_ns)};
}

// Sets `reason` when there is no usable fit.
EgoVelocity EgoVelocityEstimator::Fit(const DopplerEquations& equations,
                                      const Eigen::Vector3d& up_radar,
                                      const std::optional<VelocityGate>& temporal_gate,
                                      double vertical_ridge) {
  EgoVelocity fit;
  if (equations.size() < options_.min_inliers) {
    fit.reason = Format("%.0f returns with Doppler, at least %.0f needed",
                        equations.size(),
                        options_.min_inliers,
                        0.0);
    return fit;
  }
  // Mixed so that neighbouring seeds and scans share no draws.
  Random random(Random(static_cast<std::uint64_t>(options_.seed)).Bits() ^ num_scans_);
  const std::optional<VelocityHypothesis> hypothesis =
      DrawVelocity(equations, options_.fit_gate, options_.num_draws, temporal_gate, &random);
  if (!hypothesis) {
    fit.reason = "all returns lie in one direction";
    return fit;
  }
  fit = Refine(equations, up_radar, equations.basis * hypothesis->velocity, vertical_ridge);
  if (fit.reason.empty()) fit.reason = WhyUnusable(fit, equations, temporal_gate);
  return fit;
}

EgoVelocity EgoVelocityEstimator::Refine(const DopplerEquations& equations,
                                         const Eigen::Vector3d& up_radar,
                                         const Eigen::Vector3d& v_start,
                                         double vertical_ridge) const {
  EgoVelocity fit;
  fit.v_radar = v_start;
  Eigen::ArrayXd residuals = equations.Residuals(fit.v_radar);
  std::vector<Eigen::Index> inliers = WithinGate(residuals, options_.fit_gate);
  for (int round = 0; round < kMaxRounds; ++round) {
    if (inliers.empty()) break;
    fit.v_radar = LeastSquares(equations, inliers, up_radar, fit.v_radar, vertical_ridge);
    residuals = equations.Residuals(fit.v_radar);
    std::vector<Eigen::Index> next = WithinGate(residuals, options_.fit_gate);
    const bool is_settled = next == inliers;
    inliers = std::move(next);
    if (is_settled) break;
  }
  fit.num_inliers = static_cast<int>(inliers.size());
  if (inliers.empty()) return fit;
  double sum = 0.0;
  for (const Eigen::Index i : inliers) sum += residuals[i] * residuals[i];
  fit.residual_rms = std::sqrt(sum / static_cast<double>(inliers.size()));
  fit.covariance = Covariance(equations, residuals, up_radar, vertical_ridge);
  return fit;
}

Eigen::Vector3d EgoVelocityEstimator::LeastSquares(const DopplerEquations& equations,
                                                   const std::vector<Eigen::Index>& inliers,
                                                   const Eigen::Vector3d& up_radar,
                                                   const Eigen::Vector3d& v_start,
                                                   double vertical_ridge) const {
  CondensedDopplerFactor::Sum sum;
  for (const Eigen::Index i : inliers) {
    sum.Add(equations.Direction(i), equations.v_doppler[i], sensor_.sigma_doppler);
  }
  Eigen::Vector3d v_radar = v_start;
  ceres::Problem problem;
  problem.AddResidualBlock(CondensedDopplerFactor::Create(sum), nullptr, v_radar.data());
  const double ridge_returns = vertical_ridge * static_cast<double>(inliers.size());
  problem.AddResidualBlock(
      DopplerFactor::Create(up_radar, 0.0, sensor_.sigma_doppler / std::sqrt(ridge_returns)),
      nullptr,
      v_radar.data());
  Solve(solver_options_, &problem);
  return v_radar;
}

// Covariance of the gated least squares as an M-estimator, whatever the distribution of the noise
// (it is larger for returns across the direction of travel, where errors of the angles count):
//
//   (A + R)^-1 (S / kappa^2 + R sigma_up^2 R) (A + R)^-1
//
// A      sum of d d' over the inliers
// R      n vertical_ridge up up', which draws v_up of true size sigma_up to zero
// S      sum of residual^2 d d' over the inliers: the noise as it is
// kappa  how much of a shift of v the gated sum of residuals shows: 1 when the gate cuts nothing,
//        less when returns lie at the edge of the gate and leave the sum as others enter
Eigen::Matrix3d EgoVelocityEstimator::Covariance(const DopplerEquations& equations,
                                                 const Eigen::ArrayXd& residuals,
                                                 const Eigen::Vector3d& up_radar,
                                                 double vertical_ridge) const {
  const double gate = options_.fit_gate;
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d S = Eigen::Matrix3d::Zero();
  double num_inliers = 0.0, num_at_edge = 0.0;
  for (Eigen::Index i = 0; i < residuals.size(); ++i) {
    const double residual = std::abs(residuals[i]);
    if (std::abs(residual - gate) <= 0.25 * gate) num_at_edge += 1.0;
    if (!(residual <= gate)) continue;
    const Eigen::Vector3d d = equations.Direction(i);
    const Eigen::Matrix3d outer = d * d.transpose();
    A += outer;
    S += residual * residual * outer;
    num_inliers += 1.0;
  }
  // Three parameters have been fitted to these residuals; the prior keeps small numbers honest.
  const double variance = sensor_.sigma_doppler * sensor_.sigma_doppler;
  const double freedom = std::max(0.0, num_inliers - 3.0);
  S = (S * num_inliers + A * variance * kPriorReturns) / (freedom + kPriorReturns);
  // Density of residuals at the edge times the width of the gate, over the inliers.
  const double kappa = std::max(kMinSlope, 1.0 - 2.0 * num_at_edge / num_inliers);
  const double sigma_up = options_.vertical_sigma;
  const Eigen::Matrix3d R = num_inliers * vertical_ridge * up_radar * up_radar.transpose();
  const Eigen::Matrix3d inverse = (A + R).completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::Matrix3d covariance =
      inverse * (S / (kappa * kappa) + sigma_up * sigma_up * R * R.transpose()) * inverse;
  const double common_variance = options_.common_sigma * options_.common_sigma;
  return 0.5 * (covariance + covariance.transpose()) +
         common_variance * Eigen::Matrix3d::Identity();
}

// Standard deviation of the fit in the weakest horizontal direction [m/s]; infinite when the
// inliers leave it open. The covariance alone would not tell: it is zero there, for want of
// residuals.
double EgoVelocityEstimator::HorizontalSigma(const EgoVelocity& fit,
                                             const DopplerEquations& equations) const {
  const auto is_inlier =
      (equations.Residuals(fit.v_radar).abs() <= options_.fit_gate).cast<double>().eval();
  Eigen::Matrix2d information;
  information(0, 0) = (is_inlier * equations.first.square()).sum();
  information(1, 1) = (is_inlier * equations.second.square()).sum();
  information(0, 1) = (is_inlier * equations.first * equations.second).sum();
  information(1, 0) = information(0, 1);
  const Eigen::Matrix2d covariance = equations.basis.transpose() * fit.covariance * equations.basis;
  const double weakest =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(information).eigenvalues()[0];
  const double largest =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues()[1];
  return std::max(std::sqrt(std::max(0.0, largest)),
                  sensor_.sigma_doppler / std::sqrt(std::max(0.0, weakest)));
}

// Empty when the fit is usable.
std::string EgoVelocityEstimator::WhyUnusable(
    const EgoVelocity& fit,
    const DopplerEquations& equations,
    const std::optional<VelocityGate>& temporal_gate) const {
  const double needed =
      std::max<double>(options_.min_inliers, options_.min_inlier_share * equations.size());
  if (fit.num_inliers < needed) {
    return Format("only %.0f of %.0f returns agree on a velocity, %.0f needed",
                  fit.num_inliers,
                  equations.size(),
                  std::ceil(needed));
  }
  const double sigma = HorizontalSigma(fit, equations);
  if (!(sigma <= options_.max_sigma)) {
    return Format(
        "the returns lie too close to one direction: standard deviation %.2f m/s across "
        "it, at most %.2f allowed",
        sigma,
        options_.max_sigma,
        0.0);
  }
  const Eigen::Vector2d velocity = equations.basis.transpose() * fit.v_radar;
  if (temporal_gate && !temporal_gate->Contains(velocity)) {
    return Format("the velocity differs by %.2f m/s from the last one, at most %.2f allowed",
                  (velocity - temporal_gate->center).norm(),
                  temporal_gate->radius,
                  0.0);
  }
  return "";
}

}  // namespace radive
