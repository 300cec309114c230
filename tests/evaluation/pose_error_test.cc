// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/evaluation/absolute_pose_error.h"
#include "radive/evaluation/relative_pose_error.h"
#include "radive/util/angle_units.h"
#include "tests/evaluation/evaluation_test_utils.h"

namespace radive {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::PosesAlongX;
using testing::Rotation;

// Reference 0, 1, 3, 6 along x; the estimate overshoots by 10 % and turns by 90 degrees at the
// last pose.
MatchedPoses Matched() {
  MatchedPoses poses = {PosesAlongX({0, 1, 3, 6}), PosesAlongX({0, 1.1, 3.3, 6.6})};
  poses.estimate[3].rotation = Rotation(Eigen::Vector3d::UnitZ(), kPi / 2);
  return poses;
}

TEST(AbsolutePoseError, MeasuresEachPose) {
  std::string error;
  const MatchedPoses poses = Matched();
  EXPECT_THAT(
      *AbsolutePoseErrors(poses, PoseRelation::kTransPart, &error),
      ElementsAre(0.0, DoubleNear(0.1, 1e-12), DoubleNear(0.3, 1e-12), DoubleNear(0.6, 1e-12)));
  EXPECT_THAT(*AbsolutePoseErrors(poses, PoseRelation::kAngleDeg, &error),
              ElementsAre(0.0, 0.0, 0.0, DoubleNear(90.0, 1e-12)));
  // |R - I|_F = sqrt(4) = 2 and 0.6 m: sqrt(4.36).
  EXPECT_NEAR(
      AbsolutePoseErrors(poses, PoseRelation::kFull, &error)->back(), std::sqrt(4.36), 1e-12);
}

TEST(AbsolutePoseError, SaysWhatIsWrong) {
  std::string error;
  MatchedPoses poses = Matched();
  EXPECT_FALSE(AbsolutePoseErrors(poses, PoseRelation::kPointDistanceRatio, &error));
  EXPECT_THAT(error, HasSubstr("expected metric rpe"));
  poses.reference[2].rotation *= 1.1;
  EXPECT_FALSE(AbsolutePoseErrors(poses, PoseRelation::kAngleRad, &error));
  EXPECT_THAT(error, HasSubstr("matched pose 2: expected rotation matrices"));
}

TEST(RelativePoseError, MeasuresEachPair) {
  std::string error;
  const std::vector<PosePair> pairs = {{0, 1}, {1, 2}, {2, 3}};
  const MatchedPoses poses = Matched();
  for (const PoseRelation relation : {PoseRelation::kTransPart, PoseRelation::kPointDistance}) {
    EXPECT_THAT(
        *RelativePoseErrors(poses, pairs, relation, &error),
        ElementsAre(DoubleNear(0.1, 1e-12), DoubleNear(0.2, 1e-12), DoubleNear(0.3, 1e-12)));
  }
  EXPECT_THAT(*RelativePoseErrors(poses, pairs, PoseRelation::kAngleDeg, &error),
              ElementsAre(0.0, 0.0, DoubleNear(90.0, 1e-12)));
}

TEST(RelativePoseError, IgnoresACommonOffsetButNotAWrongHeading) {
  // The estimate drives along y with unchanged attitude: relative motion (0, 1) against (1, 0).
  MatchedPoses poses = {PosesAlongX({0, 1}), PosesAlongX({0, 0})};
  poses.estimate[0].translation = Eigen::Vector3d(100, 100, 100);
  poses.estimate[1].translation = Eigen::Vector3d(100, 101, 100);
  std::string error;
  EXPECT_NEAR(RelativePoseErrors(poses, {{0, 1}}, PoseRelation::kTransPart, &error)->front(),
              std::sqrt(2.0),
              1e-12);
  EXPECT_NEAR(RelativePoseErrors(poses, {{0, 1}}, PoseRelation::kPointDistance, &error)->front(),
              0.0,
              1e-12);
  // Turning the whole estimate so that its x axis points along its motion mends it.
  for (MatrixPose& pose : poses.estimate) {
    pose.rotation = Rotation(Eigen::Vector3d::UnitZ(), kPi / 2);
  }
  EXPECT_NEAR(
      RelativePoseErrors(poses, {{0, 1}}, PoseRelation::kTransPart, &error)->front(), 0.0, 1e-12);
}

TEST(RelativePoseError, RatioLeavesStandstillOut) {
  std::string error;
  MatchedPoses poses = {PosesAlongX({0, 0, 2}), PosesAlongX({0, 0.5, 3})};
  // |2 - 2.5| / 2 = 25 %.
  EXPECT_THAT(
      *RelativePoseErrors(poses, {{0, 1}, {1, 2}}, PoseRelation::kPointDistanceRatio, &error),
      ElementsAre(DoubleNear(25.0, 1e-12)));
  EXPECT_FALSE(RelativePoseErrors(poses, {{0, 1}}, PoseRelation::kPointDistanceRatio, &error));
  EXPECT_THAT(error, HasSubstr("stands still"));
}

}  // namespace
}  // namespace radive
