// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/street_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radive/util/angle_units.h"

namespace radive {
namespace {

TEST(StreetPath, LengthIsSidesAndCorners) {
  const StreetPath path(270.0, 113.0, 60.0);
  EXPECT_DOUBLE_EQ(path.length(), 2 * 270.0 + 2 * 113.0 + 4 * 60.0);
}

TEST(StreetPath, FirstSideIsTheXAxis) {
  const StreetPath path(100.0, 50.0, 40.0);
  const StreetPath::Point point = path.At(30.0);
  EXPECT_DOUBLE_EQ(point.position.x(), 30.0);
  EXPECT_DOUBLE_EQ(point.position.y(), 0.0);
  EXPECT_DOUBLE_EQ(point.heading, 0.0);
  EXPECT_DOUBLE_EQ(point.curvature, 0.0);
}

// In the middle of a corner the heading is 45 degrees and the curvature pi / corner.
TEST(StreetPath, CornerTurnsLeftByAQuarter) {
  const StreetPath path(100.0, 50.0, 40.0);
  const StreetPath::Point middle = path.At(120.0);
  EXPECT_NEAR(middle.heading, kPi / 4, 1e-12);
  EXPECT_NEAR(middle.curvature, kPi / 40.0, 1e-12);
  EXPECT_NEAR(path.At(140.0).heading, kPi / 2, 1e-12);
  EXPECT_NEAR(path.At(140.0).position.x() - 100.0, path.At(140.0).position.y(), 1e-9);
}

TEST(StreetPath, LoopCloses) {
  const StreetPath path(270.0, 113.0, 60.0);
  for (const double s : {-1e-9, path.length() - 1e-9, path.length(), 3.0 * path.length()}) {
    EXPECT_LT(path.At(s).position.norm(), 1e-8) << "s = " << s;
  }
  EXPECT_LT((path.At(40.0).position - path.At(40.0 - path.length()).position).norm(), 1e-9);
}

TEST(StreetPath, TangentAndCurvatureAreDerivatives) {
  const StreetPath path(270.0, 113.0, 60.0);
  constexpr double kStep = 1e-4;
  for (double s = 0.37; s < path.length() - 1.0; s += 1.9) {
    const StreetPath::Point before = path.At(s - kStep), at = path.At(s),
                            after = path.At(s + kStep);
    const Eigen::Vector2d tangent = (after.position - before.position) / (2.0 * kStep);
    EXPECT_NEAR(tangent.x(), std::cos(at.heading), 1e-7) << "s = " << s;
    EXPECT_NEAR(tangent.y(), std::sin(at.heading), 1e-7) << "s = " << s;
    EXPECT_NEAR((after.heading - before.heading) / (2.0 * kStep), at.curvature, 1e-7);
  }
}

}  // namespace
}  // namespace radive
