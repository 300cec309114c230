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

}  // namespace radive::testing
