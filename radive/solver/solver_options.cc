// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/solver/solver_options.h"

namespace radive {

std::vector<OptionField> SolverOptions::Fields() {
  return {
      OptionField{"linear_solver",
                  MakeChoice(&linear_solver,
                             {"dense_qr",
                              "dense_normal_cholesky",
                              "sparse_normal_cholesky",
                              "iterative_schur",
                              "cgnr"}),
                  "-",
                  "How the linear system of each step is solved."},
      OptionField{"max_iterations", &max_iterations, "-", "Most Levenberg-Marquardt steps."}
          .AtLeast(1)
          .AtMost(100000),
      OptionField{"function_tolerance",
                  &function_tolerance,
                  "-",
                  "Stop when a step changes the cost by less than this share of it."}
          .AtLeast(0.0)
          .AtMost(1.0),
      OptionField{"gradient_tolerance",
                  &gradient_tolerance,
                  "-",
                  "Stop when no entry of the gradient is larger than this."}
          .AtLeast(0.0),
      OptionField{"parameter_tolerance",
                  &parameter_tolerance,
                  "-",
                  "Stop when a step is shorter than this share of the parameters' norm."}
          .AtLeast(0.0)
          .AtMost(1.0),
      OptionField{"initial_trust_region_radius",
                  &initial_trust_region_radius,
                  "-",
                  "Inverse of the first damping lambda."}
          .Above(0.0),
      OptionField{"max_linear_iterations",
                  &max_linear_iterations,
                  "-",
                  "Most conjugate gradient iterations a step (cgnr, iterative_schur)."}
          .AtLeast(1)
          .AtMost(100000),
      OptionField{"linear_tolerance",
                  &linear_tolerance,
                  "-",
                  "Conjugate gradients end when one more gains less than this share."}
          .Above(0.0)
          .AtMost(1.0),
      OptionField{"num_threads", &num_threads, "-", "Threads that evaluate residual blocks."}
          .AtLeast(1)
          .AtMost(256),
  };
}

bool SolverOptions::IsValid(std::string* error) const {
  return CheckOptions("solver", *this, error);
}

}  // namespace radive
