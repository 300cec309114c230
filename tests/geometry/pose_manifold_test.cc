// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/geometry/pose_manifold.h"

#include <ceres/manifold_test_utils.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/synthetic_scene.h"

// The macro of Ceres 2.1 names its matchers without their namespace.
namespace ceres {

void ExpectManifoldInvariants(const Manifold& manifold,
                              const Eigen::VectorXd& x,
                              const Eigen::VectorXd& delta,
                              const Eigen::VectorXd& y,
                              double tolerance) {
  EXPECT_THAT_MANIFOLD_INVARIANTS_HOLD(manifold, x, delta, y, tolerance);
}

}  // namespace ceres

namespace radive {
namespace {

Eigen::VectorXd Vector(const Rigid3& T) {
  const PoseBlock block = ToPoseBlock(T);
  return Eigen::Map<const Eigen::Matrix<double, 7, 1>>(block.data());
}

Rigid3 Plus(const ceres::Manifold& manifold, const Rigid3& T, const std::vector<double>& delta) {
  PoseBlock sum;
  EXPECT_TRUE(manifold.Plus(ToPoseBlock(T).data(), delta.data(), sum.data()));
  return FromPoseBlock(sum);
}

TEST(PoseManifold, KeepsTheInvariants) {
  Random random(1);
  const PoseManifold manifold;
  for (int i = 0; i < 20; ++i) {
    const Rigid3 x = testing::RandomRigid3(3.0, 20.0, &random);
    const Rigid3 y = x * testing::RandomRigid3(1.0, 5.0, &random);
    Eigen::VectorXd delta(6);
    for (int k = 0; k < 6; ++k) delta[k] = 0.2 * random.Normal();
    ceres::ExpectManifoldInvariants(manifold, Vector(x), delta, Vector(y), 1e-9);
  }
}

// The tangent is HALF a rotation vector, multiplied from the left.
TEST(PoseManifold, TangentIsHalfTheRotationVectorOnTheLeft) {
  const Rigid3 T{QuaternionFromRotationVector({0.3, -0.2, 0.7}), {1.0, 2.0, 3.0}};
  const Rigid3 moved = Plus(PoseManifold(), T, {0.05, 0.0, 0.0, 0.1, 0.2, 0.3});
  const Eigen::Vector3d turned = RotationVector(moved.rotation * T.rotation.conjugate());
  EXPECT_LT((turned - Eigen::Vector3d(0.1, 0.0, 0.0)).norm(), 1e-15);
  EXPECT_LT((moved.translation - Eigen::Vector3d(1.1, 2.2, 3.3)).norm(), 1e-15);
}

TEST(PlanarPoseManifold, KeepsTheInvariantsForAnyNormal) {
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    // The basis of the plane takes another seed where the normal is close to x.
    const Eigen::Vector3d normal = i == 0   ? Eigen::Vector3d::UnitX()
                                   : i == 1 ? Eigen::Vector3d(0.0, 0.0, -3.0)
                                            : testing::RandomNormal3(&random);
    const PlanarPoseManifold manifold(normal);
    const Rigid3 x = testing::RandomRigid3(3.0, 20.0, &random);
    // y must be reachable from x.
    const Rigid3 y = Plus(manifold, x, {random.Uniform(-1.5, 1.5), random.Normal(), 2.0});
    Eigen::VectorXd delta(3);
    for (int k = 0; k < 3; ++k) delta[k] = 0.3 * random.Normal();
    ceres::ExpectManifoldInvariants(manifold, Vector(x), delta, Vector(y), 1e-9);
  }
}

// About z: the angle is a full one (not a half), and x, y are those of the left frame.
TEST(PlanarPoseManifold, AboutTheVertical) {
  const Rigid3 T{QuaternionFromRotationVector({0.0, 0.0, 0.4}), {1.0, 2.0, 3.0}};
  const Rigid3 moved = Plus(PlanarPoseManifold(Eigen::Vector3d::UnitZ()), T, {0.1, 0.5, 0.25});
  EXPECT_LT((RotationVector(moved.rotation) - Eigen::Vector3d(0.0, 0.0, 0.5)).norm(), 1e-15);
  EXPECT_LT((moved.translation - Eigen::Vector3d(1.5, 2.25, 3.0)).norm(), 1e-15);
}

TEST(PlanarPoseManifold, NeverLeavesThePlane) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d normal = testing::RandomUnit3(&random);
    const PlanarPoseManifold manifold(5.0 * normal);
    const Rigid3 x = testing::RandomRigid3(3.0, 20.0, &random);
    const double angle = random.Uniform(-3.0, 3.0);
    const Rigid3 y = Plus(manifold, x, {angle, random.Normal(), random.Normal()});
    EXPECT_NEAR(normal.dot(y.translation - x.translation), 0.0, 1e-13);
    const Eigen::Vector3d turned = RotationVector(y.rotation * x.rotation.conjugate());
    EXPECT_LT((turned - angle * normal).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace radive
