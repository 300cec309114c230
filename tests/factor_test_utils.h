// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/cost_function.h>
#include <ceres/gradient_checker.h>
#include <ceres/manifold.h>
#include <ceres/numeric_diff_options.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace radive::testing {

// Compares the Jacobians of `cost` with finite differences at `blocks`, in the tangent space of
// `manifolds` (a nullptr entry is a Euclidean block). The error is taken per block, because Probe()
// compares single entries relatively and so rejects exact zeros.
inline void ExpectJacobiansMatchNumeric(const ceres::CostFunction& cost,
                                        const std::vector<const ceres::Manifold*>& manifolds,
                                        const std::vector<const double*>& blocks,
                                        double tolerance = 1e-7) {
  const ceres::GradientChecker checker(&cost, &manifolds, ceres::NumericDiffOptions());
  ceres::GradientChecker::ProbeResults probe;
  checker.Probe(blocks.data(), std::numeric_limits<double>::infinity(), &probe);
  ASSERT_TRUE(probe.return_value);
  for (std::size_t i = 0; i < probe.local_jacobians.size(); ++i) {
    const auto& actual = probe.local_jacobians[i];
    const auto& expected = probe.local_numeric_jacobians[i];
    EXPECT_LE((actual - expected).norm(), tolerance * std::max(1.0, expected.norm()))
        << "block " << i << "\nautodiff:\n"
        << actual << "\nnumeric:\n"
        << expected;
  }
}

// The same with plain central differences of a small step, for costs whose second derivative jumps
// (softsign, ReLU): the extrapolation above is wrong across a jump. All blocks are Euclidean.
inline void ExpectJacobiansMatchDifferences(const ceres::CostFunction& cost,
                                            const std::vector<const double*>& blocks,
                                            double step = 1e-6,
                                            double tolerance = 1e-6) {
  const std::size_t num_residuals = static_cast<std::size_t>(cost.num_residuals());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::size_t size = static_cast<std::size_t>(cost.parameter_block_sizes()[b]);
    std::vector<double> residuals(num_residuals), jacobian(num_residuals * size);
    std::vector<double*> jacobians(blocks.size(), nullptr);
    jacobians[b] = jacobian.data();
    ASSERT_TRUE(cost.Evaluate(blocks.data(), residuals.data(), jacobians.data()));
    for (std::size_t i = 0; i < size; ++i) {
      std::vector<double> block(blocks[b], blocks[b] + size), above(num_residuals);
      std::vector<double> below(num_residuals);
      std::vector<const double*> moved = blocks;
      moved[b] = block.data();
      block[i] += step;
      ASSERT_TRUE(cost.Evaluate(moved.data(), above.data(), nullptr));
      block[i] -= 2.0 * step;
      ASSERT_TRUE(cost.Evaluate(moved.data(), below.data(), nullptr));
      for (std::size_t r = 0; r < num_residuals; ++r) {
        EXPECT_NEAR(jacobian[r * size + i], (above[r] - below[r]) / (2.0 * step), tolerance)
            << "block " << b << ", entry " << i << ", residual " << r;
      }
    }
  }
}

}  // namespace radive::testing
