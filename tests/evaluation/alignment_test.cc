// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/alignment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/evaluation/evaluation_test_utils.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::PosesAlongX;
using testing::PosesAt;
using testing::Rotation;

const std::vector<MatrixPose>& Estimate() {
  static const std::vector<MatrixPose> kPoses =
      PosesAt({{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 3}, {-1, 1, 1}});
  return kPoses;
}

// The estimate, scaled by 2, turned by 0.7 rad about a tilted axis and moved far away.
Alignment Known() {
  return {2.0, Rotation({1, 2, 3}, 0.7), Eigen::Vector3d(350000.25, 5523456.5, -40.0)};
}

std::vector<MatrixPose> Reference(double scale) {
  Alignment known = Known();
  known.scale = scale;
  std::vector<MatrixPose> poses = Estimate();
  ApplyAlignment(known, &poses);
  return poses;
}

void ExpectNear(const Alignment& actual, const Alignment& expected, double tolerance) {
  EXPECT_NEAR(actual.scale, expected.scale, tolerance);
  EXPECT_LT((actual.rotation - expected.rotation).norm(), tolerance) << actual.rotation;
  EXPECT_LT((actual.translation - expected.translation).norm(), tolerance * 100);
}

TEST(Alignment, RecoversAKnownRigidTransform) {
  std::string error;
  const auto found =
      ComputeAlignment(AlignmentMode::kSe3, Reference(1.0), Estimate(), /*first_n=*/0, &error);
  ASSERT_TRUE(found) << error;
  Alignment expected = Known();
  expected.scale = 1.0;
  ExpectNear(*found, expected, 1e-9);
}

TEST(Alignment, RecoversAKnownSimilarity) {
  std::string error;
  const auto found =
      ComputeAlignment(AlignmentMode::kSim3, Reference(2.0), Estimate(), /*first_n=*/0, &error);
  ASSERT_TRUE(found) << error;
  ExpectNear(*found, Known(), 1e-9);
}

TEST(Alignment, ScaleOnlyMovesAndTurnsNothing) {
  std::string error;
  const auto found =
      ComputeAlignment(AlignmentMode::kScaleOnly, Reference(2.0), Estimate(), 0, &error);
  ASSERT_TRUE(found) << error;
  EXPECT_NEAR(found->scale, 2.0, 1e-9);
  EXPECT_EQ(found->rotation, Eigen::Matrix3d::Identity());
  EXPECT_EQ(found->translation, Eigen::Vector3d::Zero());
}

TEST(Alignment, Se3LeavesTheScaleAlone) {
  std::string error;
  const auto found = ComputeAlignment(AlignmentMode::kSe3, Reference(2.0), Estimate(), 0, &error);
  ASSERT_TRUE(found) << error;
  EXPECT_EQ(found->scale, 1.0);
  EXPECT_LT((found->rotation - Known().rotation).norm(), 1e-9);
}

TEST(Alignment, NeverMirrors) {
  // The reference is the estimate mirrored in z: the best rotation is found, not the reflection.
  std::vector<MatrixPose> reference = Estimate();
  for (MatrixPose& pose : reference) pose.translation.z() *= -1.0;
  std::string error;
  const auto found = ComputeAlignment(AlignmentMode::kSe3, reference, Estimate(), 0, &error);
  ASSERT_TRUE(found) << error;
  EXPECT_NEAR(found->rotation.determinant(), 1.0, 1e-12);
}

TEST(Alignment, UsesTheFirstPosesOnly) {
  std::vector<MatrixPose> reference = Reference(1.0);
  reference.back().translation.x() += 1000.0;
  std::string error;
  const auto found = ComputeAlignment(AlignmentMode::kSe3, reference, Estimate(), 4, &error);
  ASSERT_TRUE(found) << error;
  EXPECT_LT((found->rotation - Known().rotation).norm(), 1e-9);
  const auto all = ComputeAlignment(AlignmentMode::kSe3, reference, Estimate(), 99, &error);
  ASSERT_TRUE(all) << error;
  EXPECT_GT((all->rotation - Known().rotation).norm(), 0.1);
}

TEST(Alignment, OriginMapsTheFirstPose) {
  std::vector<MatrixPose> reference = PosesAt({{5, 0, 0}, {9, 9, 9}});
  reference[0].rotation = Rotation(Eigen::Vector3d::UnitZ(), 0.5);
  std::vector<MatrixPose> estimate = PosesAt({{1, 0, 0}, {2, 0, 0}});
  estimate[0].rotation = Rotation(Eigen::Vector3d::UnitZ(), -0.25);
  std::string error;
  const auto found = ComputeAlignment(AlignmentMode::kOrigin, reference, estimate, 0, &error);
  ASSERT_TRUE(found) << error;
  ApplyAlignment(*found, &estimate);
  EXPECT_LT((estimate[0].translation - Eigen::Vector3d(5, 0, 0)).norm(), 1e-12);
  EXPECT_LT((estimate[0].rotation - reference[0].rotation).norm(), 1e-12);
  // One metre ahead in the estimate, which turns by 0.5 - (-0.25) rad.
  EXPECT_LT(
      (estimate[1].translation - Eigen::Vector3d(5 + std::cos(0.75), std::sin(0.75), 0)).norm(),
      1e-12);
}

TEST(Alignment, RefusesTracksThatFixNoRotation) {
  std::string error;
  const std::vector<MatrixPose> standing = PosesAlongX({5, 5, 5, 5});
  EXPECT_FALSE(ComputeAlignment(AlignmentMode::kSe3, standing, standing, 0, &error));
  EXPECT_THAT(error, HasSubstr("at least two directions"));
  const std::vector<MatrixPose> straight = PosesAlongX({0, 1, 2, 3});
  EXPECT_FALSE(ComputeAlignment(AlignmentMode::kSim3, straight, straight, 0, &error));
  EXPECT_FALSE(ComputeAlignment(AlignmentMode::kSe3, Reference(1.0), Estimate(), 2, &error));
}

TEST(ApplyAlignment, TurnsAttitudesWithoutScaling) {
  std::vector<MatrixPose> poses = PosesAlongX({1.0});
  ApplyAlignment({3.0, Rotation(Eigen::Vector3d::UnitZ(), 0.5), Eigen::Vector3d(0, 0, 1)}, &poses);
  EXPECT_LT((poses[0].rotation - Rotation(Eigen::Vector3d::UnitZ(), 0.5)).norm(), 1e-15);
  EXPECT_LT(
      (poses[0].translation - Eigen::Vector3d(3 * std::cos(0.5), 3 * std::sin(0.5), 1)).norm(),
      1e-15);
}

}  // namespace
}  // namespace radive
