// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/solver/solve.h"

#include <ceres/iteration_callback.h>
#include <ceres/solver.h>
#include <glog/logging.h>

namespace radive {
namespace {

ceres::LinearSolverType LinearSolverType(SolverOptions::LinearSolver linear_solver) {
  switch (linear_solver) {
    case SolverOptions::LinearSolver::kDenseQr:
      return ceres::DENSE_QR;
    case SolverOptions::LinearSolver::kDenseNormalCholesky:
      return ceres::DENSE_NORMAL_CHOLESKY;
    case SolverOptions::LinearSolver::kSparseNormalCholesky:
      return ceres::SPARSE_NORMAL_CHOLESKY;
    case SolverOptions::LinearSolver::kIterativeSchur:
      return ceres::ITERATIVE_SCHUR;
    case SolverOptions::LinearSolver::kCgnr:
      return ceres::CGNR;
  }
  LOG(FATAL) << "no such linear solver: " << static_cast<int>(linear_solver);
  return ceres::DENSE_QR;
}

ceres::Solver::Options CeresOptions(const SolverOptions& options,
                                    const std::vector<ceres::IterationCallback*>& callbacks) {
  ceres::Solver::Options ceres_options;
  ceres_options.minimizer_type = ceres::TRUST_REGION;
  ceres_options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
  ceres_options.linear_solver_type = LinearSolverType(options.linear_solver);
  ceres_options.preconditioner_type = ceres::JACOBI;
  ceres_options.max_num_iterations = options.max_iterations;
  ceres_options.function_tolerance = options.function_tolerance;
  ceres_options.gradient_tolerance = options.gradient_tolerance;
  ceres_options.parameter_tolerance = options.parameter_tolerance;
  ceres_options.initial_trust_region_radius = options.initial_trust_region_radius;
  ceres_options.max_linear_solver_iterations = options.max_linear_iterations;
  ceres_options.eta = options.linear_tolerance;
  ceres_options.num_threads = options.num_threads;
  ceres_options.logging_type = ceres::SILENT;
  ceres_options.minimizer_progress_to_stdout = false;
  ceres_options.callbacks = callbacks;
  ceres_options.update_state_every_iteration = !callbacks.empty();
  return ceres_options;
}

}  // namespace

// For a step dx, twice the decrease of the model is dx' H dx.
bool IsShortStep(const ceres::IterationSummary& step, double deviations) {
  return step.iteration > 0 && step.step_is_successful &&
         2.0 * step.cost_change <= deviations * deviations * step.relative_decrease;
}

SolveSummary Solve(const SolverOptions& options,
                   ceres::Problem* problem,
                   const std::vector<ceres::IterationCallback*>& callbacks) {
  CHECK(problem != nullptr);
  std::string error;
  DCHECK(options.IsValid(&error)) << error;

  const ceres::Solver::Options ceres_options = CeresOptions(options, callbacks);
  ceres::Solver::Summary ceres_summary;
  ceres::Solve(ceres_options, problem, &ceres_summary);

  SolveSummary summary;
  summary.usable = ceres_summary.IsSolutionUsable();
  summary.converged = ceres_summary.termination_type == ceres::CONVERGENCE ||
                      ceres_summary.termination_type == ceres::USER_SUCCESS;
  summary.message = ceres_summary.message;
  // The first entry of `iterations` is the starting point.
  summary.num_iterations =
      ceres_summary.iterations.empty() ? 0 : static_cast<int>(ceres_summary.iterations.size()) - 1;
  summary.initial_cost = ceres_summary.initial_cost;
  summary.final_cost = ceres_summary.final_cost;
  return summary;
}

}  // namespace radive
