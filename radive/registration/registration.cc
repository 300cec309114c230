// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/registration/registration.h"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <glog/logging.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "radive/factors/attitude_height_prior_factor.h"
#include "radive/factors/displacement_prior_factor.h"
#include "radive/factors/no_slip_factor.h"
#include "radive/factors/rotation_prior_factor.h"
#include "radive/factors/translation_prior_factor.h"
#include "radive/geometry/plane_basis.h"
#include "radive/geometry/pose_manifold.h"
#include "radive/geometry/small_matrix.h"
#include "radive/geometry/sqrt_information.h"
#include "radive/registration/icp_matcher.h"
#include "radive/registration/linearised.h"
#include "radive/registration/ndt_matcher.h"
#include "radive/registration/scan_matcher.h"
#include "radive/solver/solve.h"
#include "radive/util/number_text.h"
#include "radive/util/stopwatch.h"

namespace radive {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

// Rather short steps: so many times as long as the last one may be.
constexpr double kLooseSteps = 5.0;

// The pose is solved for relative to the prediction's position, so that the block's norm is about
// one and a relative step tolerance is one in metres and radians.
Rigid3 Shifted(const Rigid3& T_submap_radar, const Eigen::Vector3d& origin) {
  return {T_submap_radar.rotation, T_submap_radar.translation - origin};
}

Rigid3 AtOrigin(const PoseBlock& pose, const Eigen::Vector3d& origin) {
  const Rigid3 shifted = FromPoseBlock(pose);
  return {shifted.rotation, shifted.translation + origin};
}

// The no-slip factor comes last, see lateral_variance.
std::vector<std::unique_ptr<ceres::CostFunction>> MakePriorFactors(const RegistrationPriors& priors,
                                                                   const Eigen::Vector3d& origin) {
  std::vector<std::unique_ptr<ceres::CostFunction>> factors;
  if (priors.translation) {
    factors.emplace_back(
        TranslationPriorFactor::Create(priors.translation->t_submap_radar - origin,
                                       SqrtInformation<3>(priors.translation->covariance)));
  }
  if (priors.displacement) {
    const RegistrationPriors::Displacement& prior = *priors.displacement;
    factors.emplace_back(DisplacementPriorFactor::Create(Shifted(prior.T_submap_radar0, origin),
                                                         prior.displacement,
                                                         SqrtInformation<3>(prior.covariance)));
  }
  if (priors.rotation) {
    factors.emplace_back(RotationPriorFactor::Create(
        priors.rotation->q_submap_radar, SqrtInformation<3>(priors.rotation->covariance)));
  }
  if (priors.attitude_height) {
    const RegistrationPriors::AttitudeHeight& prior = *priors.attitude_height;
    factors.emplace_back(AttitudeHeightPriorFactor::Create(prior.up_radar,
                                                           prior.up_submap,
                                                           prior.t_reference - origin,
                                                           prior.sigma_angle,
                                                           prior.sigma_height));
  }
  if (priors.no_slip) {
    const RegistrationPriors::NoSlip& prior = *priors.no_slip;
    factors.emplace_back(NoSlipFactor::Create(Shifted(prior.T_submap_radar0, origin),
                                              prior.T_e_radar,
                                              prior.lateral_offset,
                                              prior.sigma));
  }
  return factors;
}

// Columns: the tangent directions that may move.
SmallMatrix FreeDirections(const RegistrationPriors& priors) {
  if (!priors.plane_normal) return Matrix6d::Identity();
  const Eigen::Vector3d n = priors.plane_normal->normalized();
  Eigen::Matrix<double, 6, 3> free = Eigen::Matrix<double, 6, 3>::Zero();
  free.block<3, 1>(0, 0) = n;
  free.block<3, 2>(3, 1) = PlaneBasis(n);
  return free;
}

// Inverse of the curvature within the span of `free`. Where the curvature is less than a twentieth
// of the hessian, or negative, the scan slides as well as it stands, and the twentieth is taken.
SmallMatrix InverseCurvature(const Matrix6d& hessian,
                             const Matrix6d& curvature,
                             const SmallMatrix& free) {
  constexpr double kSmallestShare = 0.05;
  SmallMatrix H = free.transpose() * hessian * free;
  H.diagonal().array() += 1e-9 * (1.0 + H.diagonal().maxCoeff());
  const SmallMatrix C = free.transpose() * curvature * free;
  const SmallEigen eigen = GeneralizedEigen(C, H);
  const SmallMatrix& V = eigen.vectors;  // V^T H V = I
  const SmallVector shares = eigen.values.cwiseMax(kSmallestShare);
  return V * shares.cwiseInverse().asDiagonal() * V.transpose();
}

// Covariance of an M-estimator (sandwich) within the span of `free`.
Matrix6d SandwichCovariance(const Matrix6d& hessian,
                            const Matrix6d& curvature,
                            const Matrix6d& scatter,
                            const SmallMatrix& free) {
  const SmallMatrix bread = InverseCurvature(hessian, curvature, free) * free.transpose();
  const Matrix6d covariance = bread.transpose() * (free.transpose() * scatter * free) * bread;
  return 0.5 * (covariance + covariance.transpose());
}

// Directions of rotation, and of translation, in which the data alone say little: those with a
// standard deviation beyond the limits, and those in which the pairs pull against each other so
// much that the scan slides. Along a bare wall each return finds some neighbour, so H is large
// there, but the curvature is a seventh of it; in streets it is a third at the least.
std::vector<Eigen::Matrix<double, 6, 1>> WeakDirections(const NdtQuadratic& data,
                                                        const SmallMatrix& free,
                                                        const RegistrationOptions& options) {
  constexpr double kSlidingShare = 0.25;
  SmallMatrix H = free.transpose() * data.hessian * free;
  H.diagonal().array() += 1e-9;
  const SmallMatrix agreed = InverseOf(H);
  const SmallMatrix covariance = InverseCurvature(data.hessian, data.curvature, free);
  const double limits[] = {options.degenerate_rotation, options.degenerate_translation};
  const Eigen::Index num_rotations = free.cols() / 2;  // 3 of 6, or 1 of 3
  std::vector<Eigen::Matrix<double, 6, 1>> weak;
  for (int part = 0; part < 2; ++part) {
    const Eigen::Index begin = part == 0 ? 0 : num_rotations;
    const Eigen::Index size = part == 0 ? num_rotations : free.cols() - num_rotations;
    const SmallMatrix P = covariance.block(begin, begin, size, size);
    const SmallMatrix P_agreed = agreed.block(begin, begin, size, size);
    const SmallEigen eigen = GeneralizedEigen(P, P_agreed);
    for (Eigen::Index i = 0; i < size; ++i) {
      // Along this direction P has the eigenvalue times the variance of P_agreed.
      const SmallVector direction = (P_agreed * eigen.vectors.col(i)).normalized();
      const double variance = direction.dot(P * direction);
      if (eigen.values[i] <= 1.0 / kSlidingShare && variance <= limits[part] * limits[part]) {
        continue;
      }
      weak.push_back(free.middleCols(begin, size) * direction);
    }
  }
  return weak;
}

// How often pairs are searched, and the steps after each search. All methods have the same number
// of steps.
struct Schedule {
  int num_associations;
  int max_iterations;
};

Schedule MakeSchedule(const ScanMatcher& matcher, const RegistrationOptions& options) {
  if (!matcher.associates_each_step()) return {options.num_associations, options.max_iterations};
  return {options.num_associations * options.max_iterations, 1};
}

std::unique_ptr<ScanMatcher> MakeScanMatcher(const RegistrationInput& input,
                                             const Eigen::Vector3d& origin,
                                             const PairOptions& pair_options,
                                             const RegistrationOptions& options) {
  switch (options.method) {
    case RegistrationMethod::kNdt:
    case RegistrationMethod::kFullNdt:
      return MakeNdtMatcher(*input.scan, *input.search, origin, pair_options, options);
    case RegistrationMethod::kGicp:
    case RegistrationMethod::kPlaneIcp:
    case RegistrationMethod::kIcp:
    case RegistrationMethod::kDopplerIcp:
      return MakeIcpMatcher(input, origin, pair_options, options);
  }
  LOG(FATAL) << "unknown registration method " << static_cast<int>(options.method);
  return nullptr;
}

// Length of a step in metres and radians together.
double StepLength(const PoseBlock& from, const PoseBlock& to) {
  const Rigid3 a = FromPoseBlock(from), b = FromPoseBlock(to);
  return std::hypot((b.translation - a.translation).norm(),
                    RotationVector(b.rotation * a.rotation.conjugate()).norm());
}

// Ends a solve by the lengths of its steps. Pairs that will not stay need not be followed to their
// minimum: a rather short step to where others are likely is the last one. Else it takes a short
// step after a rather short one.
class EndOfSteps : public ceres::IterationCallback {
 public:
  // `pairs_differ`: empty where no other pairs will be looked for.
  EndOfSteps(double deviations, std::function<bool()> pairs_differ)
      : deviations_(deviations), pairs_differ_(std::move(pairs_differ)) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
    if (!pairs_differ_) return EndIf(IsShortStep(step, deviations_));
    if (!IsShortStep(step, kLooseSteps * deviations_)) return EndIf(false);
    if (pairs_differ_()) return EndIf(true);
    return EndIf(std::exchange(is_near_, true) && IsShortStep(step, deviations_));
  }

 private:
  static ceres::CallbackReturnType EndIf(bool is_end) {
    return is_end ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

  const double deviations_;
  const std::function<bool()> pairs_differ_;
  bool is_near_ = false;
};

SolverOptions MakeSolverOptions(const RegistrationOptions& options) {
  SolverOptions solver;
  solver.linear_solver = SolverOptions::LinearSolver::kDenseQr;
  solver.max_iterations = options.max_iterations;
  // The cost holds a large constant, so a relative decrease means nothing: steps decide.
  solver.function_tolerance = 1e-12;
  solver.gradient_tolerance = 1e-12;
  solver.parameter_tolerance = options.step_tolerance;
  solver.initial_trust_region_radius = 1.0 / options.initial_lm_lambda;
  return solver;
}

}  // namespace

RegistrationResult Register(const RegistrationInput& input,
                            const PairOptions& pair_options,
                            const RegistrationOptions& options) {
  CHECK(input.scan != nullptr && input.search != nullptr);
  const Rigid3& T_prediction = input.T_prediction;
  const RegistrationPriors& priors = input.priors;
  const double slack = input.slack;
  RegistrationResult result;
  result.T_submap_radar = T_prediction;
  if (static_cast<int>(input.scan->size()) < options.min_gaussians) {
    result.message = std::to_string(input.scan->size()) + " Gaussians in the scan, " +
                     std::to_string(options.min_gaussians) + " needed";
    return result;
  }
  const Eigen::Vector3d origin = T_prediction.translation;
  const std::vector<std::unique_ptr<ceres::CostFunction>> prior_factors =
      MakePriorFactors(priors, origin);
  std::unique_ptr<ceres::Manifold> manifold;
  if (priors.plane_normal) {
    manifold = std::make_unique<PlanarPoseManifold>(*priors.plane_normal);
  } else {
    manifold = std::make_unique<PoseManifold>();
  }
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  const std::unique_ptr<ScanMatcher> matcher =
      MakeScanMatcher(input, origin, pair_options, options);
  const Schedule schedule = MakeSchedule(*matcher, options);
  SolverOptions solver_options = MakeSolverOptions(options);
  solver_options.max_iterations = schedule.max_iterations;

  PoseBlock pose = ToPoseBlock(Shifted(T_prediction, origin));
  Rigid3 T_match;  // where the pairs were found
  for (int association = 0; association < schedule.num_associations; ++association) {
    const Stopwatch stopwatch;
    T_match = AtOrigin(pose, origin);
    // After the first solve the pose is far better than the prediction was.
    const double slack_now = association == 0 ? slack : std::min(slack, 0.3);
    const std::unique_ptr<ScanMatch> match = matcher->Associate(T_match, slack_now);
    result.pair_search_ms += stopwatch.Milliseconds();
    result.num_pairs = match->num_pairs();
    if (result.num_pairs < options.min_gaussians) {
      result.message = std::to_string(result.num_pairs) + " pairs with the submap, " +
                       std::to_string(options.min_gaussians) + " needed";
      return result;
    }
    ceres::Problem problem(ownership);
    problem.AddParameterBlock(pose.data(), 7, manifold.get());
    match->AddTo(&problem, pose.data());
    for (const auto& factor : prior_factors) {
      problem.AddResidualBlock(factor.get(), nullptr, pose.data());
    }
    const PoseBlock before = pose;
    const bool is_last = association + 1 == schedule.num_associations;
    const auto pairs_differ = [&] { return matcher->PairsDiffer(T_match, AtOrigin(pose, origin)); };
    EndOfSteps end_of_steps(options.step_deviations,
                            is_last ? std::function<bool()>() : pairs_differ);
    std::vector<ceres::IterationCallback*> callbacks;
    if (!matcher->associates_each_step()) callbacks.push_back(&end_of_steps);
    const SolveSummary summary = Solve(solver_options, &problem, callbacks);
    result.num_iterations += summary.num_iterations;
    if (!summary.usable) {
      result.message = "solver: " + summary.message;
      return result;
    }
    result.cost = summary.final_cost - match->offset();

    const bool has_settled = matcher->associates_each_step()
                                 ? StepLength(before, pose) < options.step_tolerance
                                 : summary.converged && !pairs_differ();
    if (!is_last && !has_settled) continue;
    const NdtQuadratic quadratic = match->Quadratic(pose.data());
    Matrix6d hessian = quadratic.hessian;
    Matrix6d curvature = quadratic.curvature;
    const SmallMatrix free = FreeDirections(priors);
    // Small samples: the gradients have been fitted to.
    const double num_scan = static_cast<double>(match->num_scan_gaussians());
    Matrix6d scatter =
        num_scan / std::max(1.0, num_scan - static_cast<double>(free.cols())) * quadratic.scatter;
    for (const auto& factor : prior_factors) {
      const Linearised linearised = Linearise(*factor, pose.data());
      if (priors.no_slip && factor == prior_factors.back()) {
        // What everything else knows of the lateral displacement.
        const double sigma = priors.no_slip->sigma;
        const SmallVector row = sigma * (linearised.jacobian.row(0) * free).transpose();
        SmallMatrix H = free.transpose() * hessian * free;
        H.diagonal().array() += 1e-9 * (1.0 + H.diagonal().maxCoeff());
        result.lateral_residual = sigma * linearised.residuals[0];
        result.lateral_variance = row.dot(InverseOf(H) * row);
      }
      const Matrix6d information = linearised.jacobian.transpose() * linearised.jacobian;
      hessian += information;
      curvature += information;
      scatter += information;
    }
    result.covariance = SandwichCovariance(hessian, curvature, scatter, free);
    result.weak_directions = WeakDirections(quadratic, free, options);
    break;
  }

  const Rigid3 T_submap_radar = AtOrigin(pose, origin);
  const double moved = (T_submap_radar.translation - T_prediction.translation).norm();
  const double turned =
      RotationVector(T_submap_radar.rotation * T_prediction.rotation.conjugate()).norm();
  if (!(moved <= options.max_correction && turned <= options.max_rotation_correction)) {
    result.message = "result is " + NumberText(moved) + " m and " + NumberText(turned) +
                     " rad from the prediction";
    return result;
  }
  result.T_submap_radar = T_submap_radar;
  result.converged = true;
  return result;
}

RegistrationResult RegisterNdt(const std::vector<Gaussian3>& scan,
                               const PairSearch& search,
                               const Rigid3& T_prediction,
                               double slack,
                               const RegistrationPriors& priors,
                               const PairOptions& pair_options,
                               const RegistrationOptions& options) {
  RegistrationInput input;
  input.scan = &scan;
  input.search = &search;
  input.T_prediction = T_prediction;
  input.slack = slack;
  input.priors = priors;
  return Register(input, pair_options, options);
}

}  // namespace radive
