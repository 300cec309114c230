// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/cost_function.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "radive/geometry/pose_manifold.h"
#include "radive/geometry/rigid3.h"
#include "tests/factor_test_utils.h"
#include "tests/synthetic_scene.h"

// For factors on one pose.

namespace radive::testing {

using CostPtr = std::unique_ptr<ceres::CostFunction>;

inline Eigen::VectorXd Residuals(const CostPtr& cost, const Rigid3& T) {
  const PoseBlock pose = ToPoseBlock(T);
  const double* blocks[] = {pose.data()};
  Eigen::VectorXd residuals(cost->num_residuals());
  EXPECT_TRUE(cost->Evaluate(blocks, residuals.data(), nullptr));
  return residuals;
}

// At identity, next to it, and at random poses.
inline void ExpectAutodiffMatchesNumeric(const CostPtr& cost) {
  Random random(11);
  const PoseManifold manifold;
  std::vector<Rigid3> poses = {
      {}, {QuaternionFromRotationVector({1e-8, 1e-8, -1e-8}), {1e-8, -1e-8, 1e-8}}};
  for (int i = 0; i < 10; ++i) poses.push_back(RandomRigid3(1.5, 5.0, &random));
  for (const Rigid3& T : poses) {
    const PoseBlock pose = ToPoseBlock(T);
    ExpectJacobiansMatchNumeric(*cost, {&manifold}, {pose.data()});
  }
}

}  // namespace radive::testing
