// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/solver/solve.h"

#include <ceres/autodiff_cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace radive {
namespace {

// r = a (x - b).
struct Line {
  double a, b;
  template <typename T>
  bool operator()(const T* x, T* residual) const {
    residual[0] = a * (x[0] - b);
    return true;
  }
  static ceres::CostFunction* Create(double a, double b) {
    return new ceres::AutoDiffCostFunction<Line, 1, 1>(new Line{a, b});
  }
};

// Two unit-free observations 1 and 4 of x, the second twice as precise: the mean is
// (1 + 4 * 4) / 5 = 3.4, the cost 1/2 (2.4^2 + (2 * 0.6)^2) = 3.6.
void AddTwoLines(ceres::Problem* problem, double* x) {
  problem->AddResidualBlock(Line::Create(1.0, 1.0), nullptr, x);
  problem->AddResidualBlock(Line::Create(2.0, 4.0), nullptr, x);
}

struct Step {
  double length;
  template <typename T>
  bool operator()(const T* from, const T* to, T* residual) const {
    residual[0] = to[0] - from[0] - length;
    return true;
  }
  static ceres::CostFunction* Create(double length) {
    return new ceres::AutoDiffCostFunction<Step, 1, 1, 1>(new Step{length});
  }
};

// Three places on a line: the first at 1, steps of 2 and -1, the last at 5. The gap of 3 is shared
// by the four observations, 0.75 each: 1.75, 4.5, 4.25, at a cost of 1/2 * 4 * 0.75^2.
TEST(Solve, SharesAGapBetweenTheObservationsWithEveryLinearSolver) {
  for (int solver = 0; solver < 5; ++solver) {
    SolverOptions options;
    options.linear_solver = static_cast<SolverOptions::LinearSolver>(solver);
    double x[3] = {0.0, 0.0, 0.0};
    ceres::Problem problem;
    problem.AddResidualBlock(Line::Create(1.0, 1.0), nullptr, &x[0]);
    problem.AddResidualBlock(Step::Create(2.0), nullptr, &x[0], &x[1]);
    problem.AddResidualBlock(Step::Create(-1.0), nullptr, &x[1], &x[2]);
    problem.AddResidualBlock(Line::Create(1.0, 5.0), nullptr, &x[2]);
    const SolveSummary summary = Solve(options, &problem);
    EXPECT_TRUE(summary.usable) << solver << ": " << summary.message;
    EXPECT_TRUE(summary.converged) << solver << ": " << summary.message;
    // Ceres drops the step that meets the tolerance, and iterative solvers leave a rest of each.
    const double tolerance = solver >= 3 ? 1e-3 : 1e-6;
    EXPECT_NEAR(x[0], 1.75, tolerance) << solver;
    EXPECT_NEAR(x[1], 4.5, tolerance) << solver;
    EXPECT_NEAR(x[2], 4.25, tolerance) << solver;
    EXPECT_NEAR(summary.initial_cost, 15.5, 1e-12);  // 1/2 (1 + 4 + 1 + 25)
    EXPECT_NEAR(summary.final_cost, 1.125, 1e-6) << solver;
  }
}

TEST(Solve, FindsTheWeightedMean) {
  double x = -7.0;
  ceres::Problem problem;
  AddTwoLines(&problem, &x);
  const SolveSummary summary = Solve(SolverOptions(), &problem);
  EXPECT_TRUE(summary.converged) << summary.message;
  EXPECT_NEAR(x, 3.4, 1e-6);
  EXPECT_NEAR(summary.initial_cost, 274.0, 1e-12);  // 1/2 (8^2 + 22^2)
  EXPECT_NEAR(summary.final_cost, 3.6, 1e-12);
}

TEST(Solve, StopsAtTheMostIterationsAndSaysThatItDidNotConverge) {
  SolverOptions options;
  options.max_iterations = 1;
  options.initial_trust_region_radius = 1.0;  // lambda 1: the first step goes half of the way
  double x = -6.6;
  ceres::Problem problem;
  AddTwoLines(&problem, &x);
  const SolveSummary summary = Solve(options, &problem);
  EXPECT_TRUE(summary.usable);
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.num_iterations, 1);
  // H + lambda diag(H) = 2 H, so half of the way from -6.6 to 3.4.
  EXPECT_NEAR(x, -1.6, 1e-9);
}

struct Unusable {
  template <typename T>
  bool operator()(const T*, T*) const {
    return false;
  }
};

TEST(Solve, ReportsAFailedEvaluationAndLeavesTheBlockAlone) {
  double x = 5.0;
  ceres::Problem problem;
  problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<Unusable, 1, 1>(new Unusable), nullptr, &x);
  const SolveSummary summary = Solve(SolverOptions(), &problem);
  EXPECT_FALSE(summary.usable);
  EXPECT_FALSE(summary.converged);
  EXPECT_FALSE(summary.message.empty());
  EXPECT_EQ(x, 5.0);
}

struct WatchX : ceres::IterationCallback {
  const double* x = nullptr;
  std::vector<double> seen;
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    seen.push_back(*x);
    return ceres::SOLVER_CONTINUE;
  }
};

TEST(Solve, CallbacksSeeTheParametersOfTheirIteration) {
  double x = -7.0;
  ceres::Problem problem;
  AddTwoLines(&problem, &x);
  WatchX watch;
  watch.x = &x;
  Solve(SolverOptions(), &problem, {&watch});
  ASSERT_GE(watch.seen.size(), 2u);
  EXPECT_EQ(watch.seen.front(), -7.0);
  EXPECT_NEAR(watch.seen.back(), 3.4, 1e-6);
}

// A step whose model promised 9 and that brought 4.5: dx' H dx = 18, 4.24 standard deviations.
TEST(IsShortStep, BySquaredDeviationsOfTheModel) {
  ceres::IterationSummary step;
  step.iteration = 1;
  step.step_is_successful = true;
  step.cost_change = 4.5;
  step.relative_decrease = 0.5;
  EXPECT_TRUE(IsShortStep(step, 4.25));
  EXPECT_FALSE(IsShortStep(step, 4.23));
  EXPECT_FALSE(IsShortStep(step, 0.0));
  step.step_is_successful = false;
  EXPECT_FALSE(IsShortStep(step, 4.25));
  step.step_is_successful = true;
  step.iteration = 0;  // the starting point
  EXPECT_FALSE(IsShortStep(step, 4.25));
}

TEST(SolverOptions, NamesTheFieldThatIsOutOfRange) {
  std::string error;
  EXPECT_TRUE(SolverOptions().IsValid(&error));
  SolverOptions options;
  options.max_iterations = 0;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "solver.max_iterations must be >= 1 and <= 100000, is 0");
  options = SolverOptions();
  options.function_tolerance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_NE(error.find("function_tolerance"), std::string::npos);
}

}  // namespace
}  // namespace radive
