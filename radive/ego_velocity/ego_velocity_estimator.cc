// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/ego_velocity_estimator.h"

#include <glog/logging.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "radive/ego_velocity/velocity_branches.h"
#include "radive/factors/condensed_doppler_factor.h"
#include "radive/factors/doppler_factor.h"
#include "radive/geometry/small_matrix.h"
#include "radive/kernels/kernels.h"
#include "radive/preprocessing/occlusion_counts.h"
#include "radive/solver/solve_small.h"
#include "radive/util/number_text.h"
#include "radive/util/random.h"

namespace radive {
namespace {

constexpr int kMaxRounds = 6;

// A velocity is believed that differs from the last one by so many times what is usual, or by so
// much [m/s], besides what the vehicle can accelerate.
constexpr double kUsualChanges = 5.0;
constexpr double kSureChange = 0.5;

// The noise that the covariance assumes starts from sigma_doppler, worth this many returns, so that
// a handful of inliers that agree by chance does not claim to be exact.
constexpr double kPriorReturns = 10.0;

// Smallest slope of the estimating equation, see Covariance().
constexpr double kMinSlope = 0.3;

// Lets the ridge stand for "nothing known" where the returns leave the vertical open.
constexpr double kMinRidge = 1e-6;

// Of an upper triangle, row by row.
template <int kSize>
Eigen::Matrix<double, kSize, kSize> Symmetric(const double* upper) {
  Eigen::Matrix<double, kSize, kSize> full;
  for (int row = 0; row < kSize; ++row) {
    for (int column = row; column < kSize; ++column) {
      full(row, column) = full(column, row) = *upper++;
    }
  }
  return full;
}

// The terms of the least squares.
struct DopplerAndRidge {
  CondensedDopplerFactor doppler;  // 4 residuals
  DopplerFactor ridge;             // 1

  template <typename T>
  bool operator()(const T* const v_radar, T* residuals) const {
    return doppler(v_radar, residuals) && ridge(v_radar, residuals + 4);
  }
};

// Largest Doppler residual of a return that can hide others [m/s].
constexpr double kHidingGate = 0.5;

// Of a symmetric positive semidefinite matrix: zero in the directions that it leaves open.
Eigen::Matrix3d PseudoInverse(const Eigen::Matrix3d& matrix) {
  const SmallEigen eigen = SymmetricEigen(matrix);
  const double smallest = 3.0 * std::numeric_limits<double>::epsilon() * eigen.values[2];
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (!(eigen.values[i] > smallest)) continue;
    const Eigen::Vector3d v = eigen.vectors.col(i);
    inverse += v * v.transpose() / eigen.values[i];
  }
  return inverse;
}

}  // namespace

EgoVelocityEstimator::EgoVelocityEstimator(const EgoVelocityOptions& options,
                                           const SensorOptions& sensor,
                                           const OcclusionOptions& occlusion)
    : options_(options),
      sensor_(sensor),
      occlusion_(occlusion),
      up_radar_(sensor.T_vehicle_radar().rotation.conjugate() * Eigen::Vector3d::UnitZ()),
      forward_radar_(sensor.T_vehicle_radar().rotation.conjugate() * Eigen::Vector3d::UnitX()) {
  std::string error;
  CHECK(options_.IsValid(&error)) << error;
  CHECK(sensor_.IsValid(&error)) << error;
}

EgoVelocity EgoVelocityEstimator::Estimate(const std::vector<RadarReturn>& returns,
                                           bool is_planar,
                                           std::int64_t stamp_ns) {
  ++num_scans_;
  // A planar sensor sees the velocity in its own plane, however it is mounted.
  const Eigen::Vector3d up_radar = is_planar ? Eigen::Vector3d::UnitZ() : up_radar_;
  const double ridge = is_planar ? 1.0 : std::max(options_.vertical_ridge, kMinRidge);
  const DopplerEquations equations = MakeDopplerEquations(returns, up_radar, sensor_.doppler_span);
  const std::optional<VelocityGate> gate = TemporalGate(equations, stamp_ns);

  EgoVelocity result = Fit(equations, up_radar, gate, ridge, is_planar);
  result.num_returns = equations.size();
  if (result.reason.empty()) {
    result.reason = WhyContradictory(equations, result.v_radar, stamp_ns);
  }
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

std::string EgoVelocityEstimator::WhyContradictory(const DopplerEquations& equations,
                                                   const Eigen::Vector3d& v_radar,
                                                   std::int64_t stamp_ns) {
  if (!last_good_ || options_.temporal_gate == 0.0) return "";
  const double change = (equations.basis.transpose() * (v_radar - last_good_->v_radar)).norm();
  const bool is_known = changes_.is_known();
  const double limit =
      std::min(std::max(kUsualChanges * changes_.Value(), kSureChange), options_.temporal_gate) +
      options_.max_acceleration * SecondsSinceLastGood(stamp_ns);
  changes_.Add(change);
  if (!is_known || change <= limit) return "";
  return FormatText(
      "the velocity differs by %.2f m/s from the last one, at most %.2f after those before",
      change,
      limit);
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
                                      double vertical_ridge,
                                      bool is_planar) {
  EgoVelocity fit;
  if (equations.size() < options_.min_inliers) {
    fit.reason = FormatText(
        "%d returns with Doppler, at least %d needed", equations.size(), options_.min_inliers);
    return fit;
  }
  // Mixed so that neighbouring seeds and scans share no draws.
  Random random(Random(static_cast<std::uint64_t>(options_.seed)).Bits() ^ num_scans_);
  const std::optional<Eigen::Vector3d> v_drawn =
      Draw(equations, temporal_gate, is_planar, &random, &fit.reason);
  if (!v_drawn) return fit;
  Refined refined =
      Refine(equations, up_radar, *v_drawn, Eigen::ArrayXd::Ones(equations.size()), vertical_ridge);
  if (occlusion_.enabled) {
    const Eigen::ArrayXd weights = OcclusionWeights(equations, refined.fit.v_radar);
    const Refined weighted =
        Refine(equations, up_radar, refined.fit.v_radar, weights, vertical_ridge);
    if (weighted.fit.num_inliers >= options_.min_inliers) refined = weighted;
  }
  refined.fit.reason = WhyUnusable(refined, equations, temporal_gate);
  return refined.fit;
}

// Nothing, with the reason, when no draw gives a velocity or several do.
std::optional<Eigen::Vector3d> EgoVelocityEstimator::Draw(
    const DopplerEquations& equations,
    const std::optional<VelocityGate>& temporal_gate,
    bool is_planar,
    Random* random,
    std::string* reason) const {
  *reason = "all returns lie in one direction";
  if (!(equations.span > 0.0)) {
    std::optional<Eigen::Vector3d> v_radar;
    if (options_.hypotheses == EgoVelocityOptions::Hypotheses::kSpatial && !is_planar) {
      v_radar = DrawSpatialVelocity(
          equations, options_.fit_gate, options_.num_draws, temporal_gate, random);
    } else if (const auto hypothesis = DrawVelocity(
                   equations, options_.fit_gate, options_.num_draws, temporal_gate, random)) {
      v_radar = equations.basis * hypothesis->velocity;
    }
    if (v_radar) reason->clear();
    return v_radar;
  }
  Eigen::Vector2d forward = equations.basis.transpose() * forward_radar_;
  // A radar that looks straight up or down has no direction of travel in its plane.
  forward = forward.norm() > 0.1 ? forward.normalized() : Eigen::Vector2d::UnitX();
  const auto branch = DrawVelocityBranch(equations,
                                         options_.fit_gate,
                                         options_.num_draws,
                                         temporal_gate,
                                         forward,
                                         options_.max_speed,
                                         random);
  if (!branch) return std::nullopt;
  *reason =
      branch->is_ambiguous ? "the Doppler leaves open which multiple of its span is true" : "";
  if (branch->is_ambiguous) return std::nullopt;
  return equations.basis * branch->hypothesis.velocity;
}

Eigen::ArrayXd EgoVelocityEstimator::OcclusionWeights(const DopplerEquations& equations,
                                                      const Eigen::Vector3d& v_radar) const {
  const Eigen::ArrayXd residuals = equations.Residuals(v_radar);
  const auto n = static_cast<std::size_t>(equations.size());
  std::vector<double> azimuths(n), ranges(n);
  std::vector<bool> can_hide(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    azimuths[i] = std::atan2(equations.y[row], equations.x[row]);
    ranges[i] = equations.range[row];
    can_hide[i] = std::abs(residuals[row]) < kHidingGate;
  }
  const std::vector<int> counts = OcclusionCounts(azimuths, ranges, can_hide, occlusion_);
  Eigen::ArrayXd weights(equations.size());
  for (std::size_t i = 0; i < n; ++i) {
    const double root = 1.0 / (1.0 + counts[i]);
    weights[static_cast<Eigen::Index>(i)] = root * root;
  }
  return weights;
}

EgoVelocityEstimator::Refined EgoVelocityEstimator::Refine(const DopplerEquations& equations,
                                                           const Eigen::Vector3d& up_radar,
                                                           const Eigen::Vector3d& v_start,
                                                           const Eigen::ArrayXd& weights,
                                                           double vertical_ridge) const {
  const DopplerColumns columns = equations.Columns(&weights);
  DopplerSums sums;
  std::vector<unsigned char> inliers(static_cast<std::size_t>(equations.size() + 3) / 4), before;
  const auto sum_at = [&](const Eigen::Vector3d& v, bool with_rest) {
    const DopplerGate gate = {{v.x(), v.y(), v.z()}, options_.fit_gate, NoiseRatio()};
    ActiveKernels().sum_within_gate(columns, gate, with_rest, &sums, inliers.data());
  };
  Refined refined;
  EgoVelocity& fit = refined.fit;
  fit.v_radar = v_start;
  sum_at(fit.v_radar, /*with_rest=*/false);
  for (int round = 0; round < kMaxRounds && sums.count > 0; ++round) {
    fit.v_radar = LeastSquares(sums, up_radar, fit.v_radar, vertical_ridge);
    before = inliers;
    sum_at(fit.v_radar, /*with_rest=*/false);
    if (inliers == before) break;
  }
  fit.num_inliers = sums.count;
  if (sums.count == 0) return refined;
  sum_at(fit.v_radar, /*with_rest=*/true);
  fit.residual_rms = std::sqrt(sums.squares / sums.count);
  fit.covariance = Covariance(sums, up_radar, vertical_ridge);
  refined.directions = Symmetric<3>(sums.directions);
  return refined;
}

Eigen::Vector3d EgoVelocityEstimator::LeastSquares(const DopplerSums& sums,
                                                   const Eigen::Vector3d& up_radar,
                                                   const Eigen::Vector3d& v_start,
                                                   double vertical_ridge) const {
  const double variance = sensor_.sigma_doppler * sensor_.sigma_doppler;
  const double ridge_returns = vertical_ridge * sums.weights;
  const DopplerAndRidge residuals = {
      CondensedDopplerFactor(CondensedDopplerFactor::Sum(Symmetric<4>(sums.equations) / variance)),
      DopplerFactor(up_radar, 0.0, sensor_.sigma_doppler / std::sqrt(ridge_returns))};
  return SolveSmallLinear<5, 3>(residuals, v_start);
}

// Covariance of the gated least squares as an M-estimator, whatever the distribution of the noise
// (it is larger for returns across the direction of travel, where errors of the angles count):
//
//   (A + R)^-1 (S / kappa^2 + R sigma_up^2 R) (A + R)^-1
//
// A      sum of w d d' over the inliers, w their weights
// R      (sum of w) vertical_ridge up up', which draws v_up of true size sigma_up to zero
// S      sum of w^2 residual^2 d d' over the inliers: the noise as it is
// kappa  how much of a shift of v the gated sum of residuals shows: 1 when the gate cuts nothing,
//        less when returns lie at the edge of the gate and leave the sum as others enter
Eigen::Matrix3d EgoVelocityEstimator::Covariance(const DopplerSums& sums,
                                                 const Eigen::Vector3d& up_radar,
                                                 double vertical_ridge) const {
  const Eigen::Matrix3d A = Symmetric<4>(sums.equations).topLeftCorner<3, 3>();
  const double variance = sensor_.sigma_doppler * sensor_.sigma_doppler;
  const Eigen::Matrix3d S_prior = variance * Symmetric<3>(sums.noise);
  // Three parameters have been fitted to these residuals; the prior keeps small numbers honest.
  const double num_inliers = sums.count;
  const double freedom = std::max(0.0, num_inliers - 3.0);
  const Eigen::Matrix3d S = (Symmetric<3>(sums.scatter) * num_inliers + S_prior * kPriorReturns) /
                            (freedom + kPriorReturns);
  // Density of residuals at the edge times the width of the gate, over the inliers.
  const double kappa = std::max(kMinSlope, 1.0 - 2.0 * sums.num_at_edge / num_inliers);
  const double sigma_up = options_.vertical_sigma;
  const Eigen::Matrix3d R = sums.weights * vertical_ridge * up_radar * up_radar.transpose();
  const Eigen::Matrix3d inverse = PseudoInverse(A + R);
  const Eigen::Matrix3d covariance =
      inverse * (S / (kappa * kappa) + sigma_up * sigma_up * R * R.transpose()) * inverse;
  const double common_variance = options_.common_sigma * options_.common_sigma;
  return 0.5 * (covariance + covariance.transpose()) +
         common_variance * Eigen::Matrix3d::Identity();
}

// Standard deviation of the fit in the weakest horizontal direction [m/s]; infinite when the
// inliers leave it open. The covariance alone would not tell: it is zero there, for want of
// residuals.
double EgoVelocityEstimator::HorizontalSigma(const Refined& refined,
                                             const DopplerEquations& equations) const {
  const auto& basis = equations.basis;
  const Eigen::Matrix2d information = basis.transpose() * refined.directions * basis;
  const Eigen::Matrix2d covariance = basis.transpose() * refined.fit.covariance * basis;
  const double weakest = SymmetricEigen(information).values[0];
  const double largest = SymmetricEigen(covariance).values[1];
  return std::max(std::sqrt(std::max(0.0, largest)),
                  sensor_.sigma_doppler / std::sqrt(std::max(0.0, weakest)));
}

// Empty when the fit is usable.
std::string EgoVelocityEstimator::WhyUnusable(
    const Refined& refined,
    const DopplerEquations& equations,
    const std::optional<VelocityGate>& temporal_gate) const {
  const EgoVelocity& fit = refined.fit;
  const double needed =
      std::max<double>(options_.min_inliers, options_.min_inlier_share * equations.size());
  if (fit.num_inliers < needed) {
    return FormatText("only %d of %d returns agree on a velocity, %.0f needed",
                      fit.num_inliers,
                      equations.size(),
                      std::ceil(needed));
  }
  const double sigma = HorizontalSigma(refined, equations);
  if (!(sigma <= options_.max_sigma)) {
    return FormatText(
        "the returns lie too close to one direction: standard deviation %.2f m/s across "
        "it, at most %.2f allowed",
        sigma,
        options_.max_sigma);
  }
  const Eigen::Vector2d velocity = equations.basis.transpose() * fit.v_radar;
  if (temporal_gate && !temporal_gate->Contains(velocity)) {
    return FormatText("the velocity differs by %.2f m/s from the last one, at most %.2f allowed",
                      (velocity - temporal_gate->center).norm(),
                      temporal_gate->radius);
  }
  return "";
}

}  // namespace radive
