// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/registration/ndt_matcher.h"

#include <gtest/gtest.h>

#include <vector>

namespace radive {
namespace {

// Standard deviations of 0.4 m 10 m ahead, and of 2 m 100 m ahead.
TEST(NdtMatcher, PairsDifferOnceAGaussianMovesByAQuarterOfItsDeviation) {
  std::vector<Gaussian3> scan(2);
  scan[0].mean = {10.0, 0.0, 0.0};
  scan[0].covariance = 0.16 * Eigen::Matrix3d::Identity();
  scan[1].mean = {100.0, 0.0, 0.0};
  scan[1].covariance = 4.0 * Eigen::Matrix3d::Identity();
  const PairSearch search(scan);
  const auto matcher =
      MakeNdtMatcher(scan, search, Eigen::Vector3d::Zero(), PairOptions(), RegistrationOptions());
  const auto differ = [&matcher](double shift, double turn) {
    const Rigid3 from = {QuaternionFromRotationVector({0.0, 0.0, 1.0}), {5.0, 2.0, 0.0}};
    const Rigid3 to = {from.rotation * QuaternionFromRotationVector({0.0, 0.0, turn}),
                       from.translation + Eigen::Vector3d(0.0, 0.0, shift)};
    return matcher->PairsDiffer(from, to);
  };
  EXPECT_FALSE(differ(0.0, 0.0));
  EXPECT_FALSE(differ(0.099, 0.0));
  EXPECT_TRUE(differ(0.101, 0.0));
  EXPECT_FALSE(differ(0.0, 0.0049));  // 0.49 m of 0.5
  EXPECT_TRUE(differ(0.0, 0.0051));
}

}  // namespace
}  // namespace radive
