// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/association.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/evaluation/evaluation_test_utils.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::StampedAlongX;

// The matched stamps, read off the positions.
std::vector<double> Xs(const std::vector<MatrixPose>& poses) {
  std::vector<double> xs;
  for (const MatrixPose& pose : poses) xs.push_back(pose.translation.x());
  return xs;
}

TEST(AssociateByStamp, TakesTheNearestWithinTheLimit) {
  std::string error;
  const auto matched = AssociateByStamp(
      StampedAlongX({0.0, 1.0, 2.0, 3.0}), StampedAlongX({0.25, 1.5, 2.75}), 0.25, &error);
  ASSERT_TRUE(matched) << error;
  EXPECT_THAT(Xs(matched->reference), ElementsAre(0.0, 3.0));
  EXPECT_THAT(Xs(matched->estimate), ElementsAre(0.25, 2.75));
}

TEST(AssociateByStamp, TheShorterOneLeads) {
  // Two references, four estimates: each reference looks for its estimate.
  std::string error;
  const auto matched = AssociateByStamp(
      StampedAlongX({1.0, 2.0}), StampedAlongX({0.875, 1.0625, 1.25, 2.5}), 0.5, &error);
  ASSERT_TRUE(matched) << error;
  EXPECT_THAT(Xs(matched->reference), ElementsAre(1.0, 2.0));
  EXPECT_THAT(Xs(matched->estimate), ElementsAre(1.0625, 2.5));
}

TEST(AssociateByStamp, TheEstimateLeadsWhenBothAreEquallyLong) {
  // Both estimates are nearest to reference 0, which is used twice.
  std::string error;
  const auto matched =
      AssociateByStamp(StampedAlongX({0.0, 9.0}), StampedAlongX({0.0, 0.5}), 1.0, &error);
  ASSERT_TRUE(matched) << error;
  EXPECT_THAT(Xs(matched->reference), ElementsAre(0.0, 0.0));
  EXPECT_THAT(Xs(matched->estimate), ElementsAre(0.0, 0.5));
}

TEST(AssociateByStamp, TheEarlierOneWinsATie) {
  std::string error;
  const auto matched =
      AssociateByStamp(StampedAlongX({0.0, 1.0}), StampedAlongX({0.5}), 0.5, &error);
  ASSERT_TRUE(matched) << error;
  EXPECT_THAT(Xs(matched->reference), ElementsAre(0.0));
}

TEST(AssociateByStamp, StampsNeedNotAscend) {
  std::string error;
  const auto matched =
      AssociateByStamp(StampedAlongX({3.0, 1.0, 2.0, 0.0}), StampedAlongX({2.0, 0.0}), 0.0, &error);
  ASSERT_TRUE(matched) << error;
  EXPECT_THAT(Xs(matched->reference), ElementsAre(2.0, 0.0));
}

TEST(AssociateByStamp, SaysWhenNothingMatches) {
  std::string error;
  EXPECT_FALSE(AssociateByStamp(StampedAlongX({0.0, 1.0}), StampedAlongX({5.0}), 0.5, &error));
  EXPECT_THAT(error, HasSubstr("reference spans 0.000000000 to 1.000000000 s"));
  EXPECT_THAT(error, HasSubstr("estimate spans 5.000000000"));
  EXPECT_FALSE(AssociateByStamp({}, StampedAlongX({5.0}), 0.5, &error));
  EXPECT_FALSE(AssociateByStamp(StampedAlongX({5.0}), {}, 0.5, &error));
  EXPECT_THAT(error, HasSubstr("is empty"));
}

TEST(AssociateByIndex, NeedsEqualLengths) {
  std::string error;
  EXPECT_FALSE(AssociateByIndex(StampedAlongX({0.0, 1.0}), StampedAlongX({0.0}), &error));
  EXPECT_THAT(error, HasSubstr("found 1 and 2"));
  const auto matched =
      AssociateByIndex(StampedAlongX({0.0, 1.0}), StampedAlongX({7.0, 8.0}), &error);
  ASSERT_TRUE(matched) << error;
  EXPECT_THAT(Xs(matched->estimate), ElementsAre(7.0, 8.0));
}

TEST(AssociateInterpolated, BringsTheReferenceToTheStampsOfTheEstimate) {
  RecordedTrajectory reference = StampedAlongX({2.0, 0.0, 1.0, 5.0});
  // The pose at 1 s has turned by a quarter.
  reference[2].T_world_body.rotation =
      testing::Rotation(Eigen::Vector3d::UnitZ(), 1.5707963267948966);
  std::string error;
  const auto matched = AssociateInterpolated(
      reference, StampedAlongX({-0.5, 0.25, 1.0, 3.0, 5.0, 5.5}), 1.5, &error);
  ASSERT_TRUE(matched) << error;
  // Outside, and in a gap of 3 s, there is nothing.
  EXPECT_THAT(Xs(matched->estimate), ElementsAre(0.25, 1.0, 5.0));
  EXPECT_THAT(Xs(matched->reference), ElementsAre(0.25, 1.0, 5.0));
  // A quarter of the way to a quarter turn.
  EXPECT_NEAR(matched->reference[0].rotation(1, 0), std::sin(1.5707963267948966 / 4), 1e-12);
  EXPECT_FALSE(AssociateInterpolated(reference, StampedAlongX({9.0}), 1.5, &error));
  EXPECT_THAT(error, HasSubstr("no pose of the estimate lies between"));
}

}  // namespace
}  // namespace radive
