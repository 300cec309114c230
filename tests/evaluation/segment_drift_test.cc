// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/evaluation/segment_drift.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/evaluation/evaluation_test_utils.h"

namespace radive {
namespace {

using ::testing::HasSubstr;
using testing::PosesAlongX;
using testing::Rotation;

// A straight drive in steps of 10 m; the estimate is 1 % too long.
MatchedPoses StraightDrive(int num_poses) {
  std::vector<double> reference, estimate;
  for (int i = 0; i < num_poses; ++i) {
    reference.push_back(10.0 * i);
    estimate.push_back(10.1 * i);
  }
  return {PosesAlongX(reference), PosesAlongX(estimate)};
}

TEST(SegmentDrift, MeasuresAScaleError) {
  // 240 m: segments of 100 m from poses 0 and 10, of 200 m from pose 0. Each ends at the first pose
  // beyond its length: after 110 m or 210 m, where the estimate is 1 % of that too far.
  std::string error;
  const auto drift = ComputeSegmentDrift(StraightDrive(25), 10, &error);
  ASSERT_TRUE(drift) << error;
  ASSERT_EQ(drift->segments.size(), 3u);
  EXPECT_EQ(drift->segments[0].first_pose, 0);
  EXPECT_EQ(drift->segments[0].length, 100.0);
  EXPECT_NEAR(drift->segments[0].translation, 1.1 / 100.0, 1e-12);
  EXPECT_EQ(drift->segments[1].length, 200.0);
  EXPECT_NEAR(drift->segments[1].translation, 2.1 / 200.0, 1e-12);
  EXPECT_EQ(drift->segments[2].first_pose, 10);
  EXPECT_NEAR(drift->translation, (0.011 + 0.0105 + 0.011) / 3.0, 1e-12);
  EXPECT_EQ(drift->rotation, 0.0);
}

TEST(SegmentDrift, MeasuresARotationPerMetre) {
  // The estimate yaws by 0.5 mrad a step, so by 5.5 mrad after 110 m.
  MatchedPoses poses = StraightDrive(12);
  for (std::size_t i = 0; i < poses.estimate.size(); ++i) {
    poses.estimate[i].rotation =
        Rotation(Eigen::Vector3d::UnitZ(), 0.0005 * static_cast<double>(i));
  }
  std::string error;
  const auto drift = ComputeSegmentDrift(poses, 10, &error);
  ASSERT_TRUE(drift) << error;
  EXPECT_NEAR(drift->rotation, 5.5e-5, 1e-10);
}

TEST(SegmentDrift, NeedsMoreThanAHundredMetres) {
  // Exactly 100 m does not complete a segment.
  std::string error;
  EXPECT_FALSE(ComputeSegmentDrift(StraightDrive(11), 10, &error));
  EXPECT_THAT(error, HasSubstr("more than 100 m of matched reference path, found 100.0"));
}

}  // namespace
}  // namespace radive
