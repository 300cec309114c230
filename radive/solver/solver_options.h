// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// Options of one least-squares problem. Every field has a working default, chosen for small dense
// problems such as one pose or one velocity.
struct SolverOptions {
  enum class LinearSolver {
    kDenseQr,
    kDenseNormalCholesky,
    kSparseNormalCholesky,
    kIterativeSchur,
    kCgnr,
  };

  LinearSolver linear_solver = LinearSolver::kDenseQr;
  int max_iterations = 20;

  // Solving stops when a step changes the cost by less than this share of it [-]. A cost with a
  // large constant part, such as the sum over NDT pairs, needs 1e-9 or less.
  double function_tolerance = 1e-9;

  // ... when the largest entry of the gradient is below this [1/unit of the parameters].
  double gradient_tolerance = 1e-12;

  // ... when a step is shorter than this share of the parameters' norm [-].
  double parameter_tolerance = 1e-9;

  // Inverse of the first Levenberg-Marquardt damping lambda [-].
  double initial_trust_region_radius = 1e4;

  // kCgnr and kIterativeSchur solve for a step by conjugate gradients, preconditioned with the
  // diagonal blocks (JACOBI): at most so many of them, and until the quadratic model gains less
  // than this share by one more.
  int max_linear_iterations = 500;
  double linear_tolerance = 0.1;  // [-]

  int num_threads = 1;

  std::vector<OptionField> Fields();

  // True when all fields are in range; otherwise says in `error` which is not, and the rule.
  bool IsValid(std::string* error) const;
};

}  // namespace radive
