// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/geometry/rigid3.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "radive/geometry/sqrt_information.h"
#include "radive/util/angle_units.h"
#include "tests/synthetic_scene.h"

namespace radive {
namespace {

// a sees b at (1, 2, 3), turned 90 degrees to the left: the x axis of b is the y axis of a.
TEST(Rigid3, MapsFromItsRightFrameToItsLeft) {
  const Rigid3 T_a_b{QuaternionFromRotationVector({0.0, 0.0, 0.5 * kPi}), {1.0, 2.0, 3.0}};
  EXPECT_LT((T_a_b * Eigen::Vector3d(1.0, 0.0, 0.0) - Eigen::Vector3d(1.0, 3.0, 3.0)).norm(),
            1e-15);
  EXPECT_LT((T_a_b * Eigen::Vector3d(0.0, 1.0, 0.5) - Eigen::Vector3d(0.0, 2.0, 3.5)).norm(),
            1e-15);
}

TEST(Rigid3, NeighbouringFramesCancel) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Rigid3 T_a_b = testing::RandomRigid3(kPi, 20.0, &random);
    const Rigid3 T_b_c = testing::RandomRigid3(kPi, 20.0, &random);
    const Eigen::Vector3d p_c = 10.0 * testing::RandomNormal3(&random);
    EXPECT_LT(((T_a_b * T_b_c) * p_c - T_a_b * (T_b_c * p_c)).norm(), 1e-12);
    EXPECT_LT((T_a_b.Inverse() * (T_a_b * p_c) - p_c).norm(), 1e-12);
    const Rigid3 identity = T_a_b * T_a_b.Inverse();
    EXPECT_LT(identity.translation.norm() + RotationVector(identity.rotation).norm(), 1e-13);
  }
}

TEST(Rigid3, LongChainsStayRotations) {
  const Rigid3 step{QuaternionFromRotationVector({1e-3, -2e-3, 0.0123}), {0.1, 0.0, 0.0}};
  Rigid3 T_world_radar;
  for (int i = 0; i < 200000; ++i) T_world_radar = T_world_radar * step;
  EXPECT_NEAR(T_world_radar.rotation.norm(), 1.0, 1e-15);
  EXPECT_TRUE(T_world_radar.translation.allFinite());
}

TEST(Rigid3, PoseBlockIsVectorPartScalarTranslation) {
  const Rigid3 T{Eigen::Quaterniond(0.5, 0.1, -0.7, 0.5).normalized(), {4.0, 5.0, 6.0}};
  const PoseBlock block = ToPoseBlock(T);
  EXPECT_NEAR(block[0], 0.1, 1e-15);  // 0.25 + 0.01 + 0.49 + 0.25 = 1
  EXPECT_NEAR(block[1], -0.7, 1e-15);
  EXPECT_NEAR(block[3], 0.5, 1e-15);
  EXPECT_EQ(block[4], 4.0);
  EXPECT_EQ(block[6], 6.0);
  EXPECT_LT((FromPoseBlock(block).RotationMatrix() - T.RotationMatrix()).norm(), 1e-15);
}

TEST(RotationVector, IsAxisTimesAngle) {
  EXPECT_LT(
      (RotationVector(Eigen::Quaterniond(0.0, 0.0, 0.0, 1.0)) - Eigen::Vector3d(0.0, 0.0, kPi))
          .norm(),
      1e-15);
  const Eigen::Quaterniond q(std::cos(0.3), 0.0, std::sin(0.3), 0.0);
  EXPECT_LT((RotationVector(q) - Eigen::Vector3d(0.0, 0.6, 0.0)).norm(), 1e-15);
  // The opposite quaternion is the same rotation.
  EXPECT_LT(
      (RotationVector(Eigen::Quaterniond(-q.coeffs())) - Eigen::Vector3d(0.0, 0.6, 0.0)).norm(),
      1e-15);
}

TEST(RotationVector, InvertsItsQuaternionNearZeroAndFarFromIt) {
  Random random(2);
  for (const double angle : {0.0, 1e-15, 1e-10, 0.99e-9, 1.01e-9, 1e-8, 1e-4, 1.0, 3.14}) {
    const Eigen::Vector3d expected = angle * testing::RandomUnit3(&random);
    const Eigen::Quaterniond q = QuaternionFromRotationVector(expected);
    EXPECT_NEAR(q.norm(), 1.0, 1e-15);
    EXPECT_LE((RotationVector(q) - expected).norm(), 1e-14 * angle) << angle;
  }
}

TEST(Skew, IsTheCrossProduct) {
  const Eigen::Vector3d a(1.0, -2.0, 3.0), b(0.5, 4.0, -1.0);
  EXPECT_LT((Skew(a) * b - a.cross(b)).norm(), 1e-15);
}

// Covariance L L^T with L = [2 0 0; 1 3 0; -1 2 4] by hand, and L^-1 by forward substitution. The
// transposed matrix would have the same product for diagonal covariances only.
TEST(SqrtInformation, IsTheInverseOfTheLowerCholeskyFactor) {
  Eigen::Matrix3d covariance;
  covariance << 4.0, 2.0, -2.0, 2.0, 10.0, 5.0, -2.0, 5.0, 21.0;
  Eigen::Matrix3d expected;
  expected << 1.0 / 2.0, 0.0, 0.0,  //
      -1.0 / 6.0, 1.0 / 3.0, 0.0,   //
      5.0 / 24.0, -1.0 / 6.0, 1.0 / 4.0;
  const Eigen::Matrix3d W = SqrtInformation<3>(covariance);
  EXPECT_LT((W - expected).norm(), 1e-15) << W;
  EXPECT_LT((W.transpose() * W - covariance.inverse()).norm(), 1e-14);
  // W W^T is not the information: the order matters for this matrix.
  EXPECT_GT((W * W.transpose() - covariance.inverse()).norm(), 0.05);
}

// Whitened draws of a full covariance have unit covariance.
TEST(SqrtInformation, WhitensWhatHasTheCovariance) {
  Random random(3);
  Eigen::Matrix3d covariance;
  covariance << 4.0, 2.0, -2.0, 2.0, 10.0, 5.0, -2.0, 5.0, 21.0;
  const Eigen::Matrix3d W = SqrtInformation<3>(covariance);
  constexpr int kDraws = 20000;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d e = W * testing::RandomDraw(covariance, &random);
    sum += e * e.transpose();
  }
  // Entries have standard deviations of at most sqrt(2 / kDraws) = 0.01.
  EXPECT_LT((sum / kDraws - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 0.04);
}

TEST(SqrtInformation, OfSixDimensions) {
  Random random(4);
  Eigen::Matrix<double, 6, 6> root;
  for (int i = 0; i < 36; ++i) root(i / 6, i % 6) = random.Normal();
  const Eigen::Matrix<double, 6, 6> covariance =
      root * root.transpose() + Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::Matrix<double, 6, 6> W = SqrtInformation<6>(covariance);
  EXPECT_LT((W * covariance * W.transpose() - Eigen::Matrix<double, 6, 6>::Identity()).norm(),
            1e-12);
}

}  // namespace
}  // namespace radive
