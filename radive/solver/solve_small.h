// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <Eigen/Core>

namespace radive {

// Least squares over the residuals of one functor with a handful of parameters, by Ceres' solver
// for those: Levenberg-Marquardt like Solve(), with Jacobians by autodiff, but without a problem, a
// report and memory, which cost twenty times as much as such a solve. For functors that are linear
// in the parameters the first step is the solution: it is hardly damped.
template <int kNumResiduals, int kNumParameters, typename Functor>
Eigen::Matrix<double, kNumParameters, 1> SolveSmallLinear(
    const Functor& functor, Eigen::Matrix<double, kNumParameters, 1> start) {
  using Function = ceres::TinySolverAutoDiffFunction<Functor, kNumResiduals, kNumParameters>;
  ceres::TinySolver<Function> solver;
  solver.options.max_num_iterations = 5;
  solver.options.initial_trust_region_radius = 1e16;
  const Function function(functor);
  solver.Solve(function, &start);
  return start;
}

}  // namespace radive
