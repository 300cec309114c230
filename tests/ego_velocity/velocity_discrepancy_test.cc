// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/velocity_discrepancy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/ego_velocity/made_returns.h"

namespace radive {
namespace {

using testing::At;
using ::testing::ElementsAre;

// Driving at 10 m/s ahead. Discrepancies: 0, 0.5, 0.5 (the other way), and at (3, 4), where -6 is
// expected, 2.
std::vector<RadarReturn> Returns() {
  return {At(20, 0, -10), At(30, 0, -9.5), At(5, 0, -10.5), At(3, 4, -4)};
}

const Eigen::Vector3d kVelocity(10.0, 0.0, 0.0);

TEST(VelocityDiscrepancy, IsTheAmountByWhichTheDopplerDiffers) {
  const auto returns = Returns();
  EXPECT_NEAR(VelocityDiscrepancy(returns[0], kVelocity), 0.0, 1e-12);
  EXPECT_NEAR(VelocityDiscrepancy(returns[1], kVelocity), 0.5, 1e-12);
  EXPECT_NEAR(VelocityDiscrepancy(returns[2], kVelocity), 0.5, 1e-12);
  EXPECT_NEAR(VelocityDiscrepancy(returns[3], kVelocity), 2.0, 1e-12);
}

TEST(DiscrepancyWeights, DecayWithTheScale) {
  const std::vector<double> weights = DiscrepancyWeights(Returns(), kVelocity, 0.5);
  ASSERT_EQ(weights.size(), 4u);
  EXPECT_NEAR(weights[0], 1.0, 1e-12);
  EXPECT_NEAR(weights[1], std::exp(-1.0), 1e-12);
  EXPECT_NEAR(weights[2], std::exp(-1.0), 1e-12);
  EXPECT_NEAR(weights[3], std::exp(-4.0), 1e-12);
}

TEST(KeepMask, HoldsTheGate) {
  EXPECT_THAT(KeepMask(Returns(), kVelocity, 0.6), ElementsAre(true, true, true, false));
  EXPECT_THAT(KeepMask(Returns(), kVelocity, 0.4), ElementsAre(true, false, false, false));
}

TEST(VelocityDiscrepancy, ReturnsWithoutDirectionOrDopplerAreWorthNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<RadarReturn> returns = {At(0, 0, 0), At(3, 4, nan), At(nan, 4, 0)};
  EXPECT_THAT(DiscrepancyWeights(returns, kVelocity, 1.0), ElementsAre(0.0, 0.0, 0.0));
  EXPECT_THAT(KeepMask(returns, kVelocity, 1e9), ElementsAre(false, false, false));
}

}  // namespace
}  // namespace radive
