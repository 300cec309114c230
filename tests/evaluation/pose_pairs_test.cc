// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/pose_pairs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/util/angle_units.h"
#include "tests/evaluation/evaluation_test_utils.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;
using testing::PosesAlongX;
using testing::PosesTurned;

std::vector<PosePair> Select(const std::vector<MatrixPose>& poses,
                             double delta,
                             DeltaUnit unit,
                             bool all_pairs) {
  std::string error;
  const auto pairs = SelectPosePairs(poses, {delta, unit, all_pairs}, &error);
  EXPECT_TRUE(pairs) << error;
  return pairs.value_or(std::vector<PosePair>());
}

TEST(PosePairs, Frames) {
  const std::vector<MatrixPose> poses = PosesAlongX({0, 1, 2, 3, 4});
  EXPECT_THAT(Select(poses, 2, DeltaUnit::kFrames, false), ElementsAre(Pair(0, 2), Pair(2, 4)));
  EXPECT_THAT(Select(poses, 2, DeltaUnit::kFrames, true),
              ElementsAre(Pair(0, 2), Pair(1, 3), Pair(2, 4)));
  EXPECT_THAT(Select(poses, 3, DeltaUnit::kFrames, false), ElementsAre(Pair(0, 3)));
}

TEST(PosePairs, MetresOneAfterTheOtherLeaveTheFirstStretchOut) {
  // Anchors: at 1.5 (walked 1.5), at 2.5 (1.0), at 4.0 (0.5 + 1.0). Excess is not carried over.
  const std::vector<MatrixPose> poses = PosesAlongX({0, 0.5, 1.5, 2.5, 3.0, 4.0, 4.5});
  EXPECT_THAT(Select(poses, 1, DeltaUnit::kMetres, false), ElementsAre(Pair(2, 3), Pair(3, 5)));
}

TEST(PosePairs, AllMetrePairsKeepWhatIsWithinTenPerCent) {
  // From 0: 1.05 is nearest to 1. From 1.05: 2.0 is 0.95 on. From 2.0: 3.5 is too far.
  const std::vector<MatrixPose> poses = PosesAlongX({0, 1.05, 2.0, 3.5});
  EXPECT_THAT(Select(poses, 1, DeltaUnit::kMetres, true), ElementsAre(Pair(0, 1), Pair(1, 2)));
}

TEST(PosePairs, AllMetrePairsTakeTheFirstOfEquallyNear) {
  // Standing still at 1.0 gives three candidates; 0.9375 and 1.0625 from 5 are a tie.
  EXPECT_THAT(Select(PosesAlongX({0, 1, 1, 1}), 1, DeltaUnit::kMetres, true),
              ElementsAre(Pair(0, 1)));
  EXPECT_THAT(Select(PosesAlongX({5, 5.9375, 6.0625}), 1, DeltaUnit::kMetres, true),
              ElementsAre(Pair(0, 1)));
}

TEST(PosePairs, MetresFollowThePathNotTheBeeline) {
  // Forth and back: path lengths 0, 1, 2.
  EXPECT_THAT(Select(PosesAlongX({0, 1, 0}), 2, DeltaUnit::kMetres, true), ElementsAre(Pair(0, 2)));
}

TEST(PosePairs, AnglesOneAfterTheOtherStartAtTheFirstPose) {
  // Turns of 0.6, 0.9, 0.6, -0.5 rad: sums reach 1 at pose 2 (1.5) and at pose 4 (0.6 + 0.5); what
  // the first sum had too much is not carried over.
  const std::vector<MatrixPose> poses = PosesTurned({0, 0.6, 1.5, 2.1, 1.6});
  EXPECT_THAT(Select(poses, 1, DeltaUnit::kRadians, false), ElementsAre(Pair(0, 2), Pair(2, 4)));
  EXPECT_THAT(Select(poses, Degrees(1.0), DeltaUnit::kDegrees, false),
              ElementsAre(Pair(0, 2), Pair(2, 4)));
}

TEST(PosePairs, AllAnglePairsAreDirectAngles) {
  // Within 0.9 to 1.1 rad are only 0 to 1.0, twice, and 0.7 to 1.65.
  const std::vector<MatrixPose> poses = PosesTurned({0, 0.7, 1.0, 1.65, 1.0});
  EXPECT_THAT(Select(poses, 1, DeltaUnit::kRadians, true),
              ElementsAre(Pair(0, 2), Pair(0, 4), Pair(1, 3)));
}

TEST(PosePairs, SaysWhatIsWrong) {
  std::string error;
  const std::vector<MatrixPose> poses = PosesAlongX({0, 1, 2});
  EXPECT_FALSE(SelectPosePairs(poses, {3, DeltaUnit::kFrames, false}, &error));
  EXPECT_THAT(error, HasSubstr("3 matched poses"));
  EXPECT_FALSE(SelectPosePairs(poses, {1.5, DeltaUnit::kFrames, false}, &error));
  EXPECT_THAT(error, HasSubstr("whole number"));
  EXPECT_FALSE(SelectPosePairs(poses, {-1, DeltaUnit::kMetres, false}, &error));
  EXPECT_THAT(error, HasSubstr("delta must be > 0"));
  EXPECT_FALSE(SelectPosePairs(poses, {10, DeltaUnit::kDegrees, false}, &error));
  EXPECT_THAT(error, HasSubstr("10.000000 deg apart"));
  EXPECT_FALSE(SelectPosePairs({}, {1, DeltaUnit::kMetres, true}, &error));

  std::vector<MatrixPose> sheared = poses;
  sheared[1].rotation *= 2.0;
  EXPECT_FALSE(SelectPosePairs(sheared, {10, DeltaUnit::kDegrees, false}, &error));
  EXPECT_THAT(error, HasSubstr("matched pose 1"));
}

}  // namespace
}  // namespace radive
