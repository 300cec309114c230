// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/solver/solver_options.h"

namespace ceres {
class IterationCallback;
class Problem;
struct IterationSummary;
}  // namespace ceres

namespace radive {

// How a solve ended.
struct SolveSummary {
  // The parameter blocks hold the best point that was found; false: an evaluation failed and they
  // are as they were before.
  bool usable = false;
  bool converged = false;  // one of the tolerances was met
  std::string message;     // why it stopped, in words
  int num_iterations = 0;  // Levenberg-Marquardt steps, rejected ones included
  double initial_cost = 0.0;
  double final_cost = 0.0;
};

// Whether a step was taken that the covariance can hardly tell from none: shorter than so many
// standard deviations, as the matrix of the normal equations has them when the residuals are
// whitened.
bool IsShortStep(const ceres::IterationSummary& step, double deviations);

// Minimises 1/2 sum rho(|r|^2) over the parameter blocks of `problem`, by Levenberg-Marquardt with
// the damping lambda diag(H) of the paper. The only call of ceres::Solve in the project.
//
// Prints no progress (Ceres itself logs failed evaluations through glog). `options` must be valid.
// `callbacks` are called after each step, with the parameter blocks up to date; they stay the
// caller's.
SolveSummary Solve(const SolverOptions& options,
                   ceres::Problem* problem,
                   const std::vector<ceres::IterationCallback*>& callbacks = {});

}  // namespace radive
