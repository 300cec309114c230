// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/displacement_votes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "radive/ego_velocity/spread_points.h"
#include "radive/util/random.h"
#include "tests/with_kernels.h"

namespace radive {
namespace {

using Points = std::vector<Eigen::Vector2d>;

// Five places, no two of whose differences are alike.
const Points kPlaces = {{10.0, 3.0}, {17.0, -8.0}, {4.0, 21.0}, {31.0, 13.0}, {-9.0, -14.0}};

VotingPoints All(const Points& points) { return MakeVotingPoints(points, 100); }

// What a radar sees of kPlaces after it has moved by the chord and turned.
Points SeenAfter(const Eigen::Vector2d& chord, double turn) {
  const Eigen::Rotation2Dd half(0.5 * turn);
  Points seen;
  for (const Eigen::Vector2d& p : kPlaces) {
    seen.push_back(half.inverse() * (half.inverse() * p - chord));
  }
  return seen;
}

TEST(DisplacementVotes, MostAreForTheMotion) {
  const Eigen::Vector2d chord(3.0, -0.5);
  for (const double turn : {-0.06, 0.0, 0.1}) {
    const DisplacementVotes votes(All(kPlaces), All(SeenAfter(chord, turn)), 0.1);
    EXPECT_LE((votes.Best() - chord).cwiseAbs().maxCoeff(), 0.75) << turn;
    EXPECT_NEAR(votes.At(chord), 5.0, 1e-5) << turn;
    EXPECT_LE(votes.At(-chord), 1.0);
    EXPECT_LT(votes.Mean(), 0.2);
  }
}

TEST(DisplacementVotes, SwappingTheScansTurnsTheDisplacement) {
  const Eigen::Vector2d chord(3.0, -0.5);
  const DisplacementVotes votes(All(SeenAfter(chord, 0.0)), All(kPlaces), 0.1);
  EXPECT_NEAR(votes.At(-chord), 5.0, 1e-5);
  EXPECT_LE(votes.At(chord), 1.0);
}

TEST(DisplacementVotes, BeyondTheReachCountsAsChance) {
  const DisplacementVotes votes(All(kPlaces), All(kPlaces), 0.0);
  EXPECT_EQ(votes.At({100.0, 0.0}), votes.Mean());
  EXPECT_NEAR(votes.At({0.0, 0.0}), 5.0, 1e-5);
}

TEST(DisplacementVotes, FadingKeepsAShare) {
  const DisplacementVotes now(All(kPlaces), All(kPlaces), 0.0);
  DisplacementVotes sum;
  EXPECT_EQ(sum.At({0.0, 0.0}), 0.0);
  sum.Fade(0.5, now);
  sum.Fade(0.5, now);
  EXPECT_NEAR(sum.At({0.0, 0.0}), 7.5, 1e-5);
}

// Rounding of the turned points may put a pair into the next cell, by a part of a vote.
TEST(DisplacementVotes, AreTheSameByAllKernels) {
  Random random(3);
  Points before, after;
  for (int i = 0; i < 300; ++i) {
    before.emplace_back(random.Uniform(-60.0, 60.0), random.Uniform(-60.0, 60.0));
    after.emplace_back(before.back() - Eigen::Vector2d(1.5, 0.2));
  }
  std::vector<DisplacementVotes> votes;
  for (const Kernels* kernels : AvailableKernels()) {
    const testing::WithKernels with_kernels(*kernels);
    votes.emplace_back(All(before), All(after), 0.05);
  }
  for (double x = -12.0; x <= 12.0; x += 0.5) {
    EXPECT_NEAR(votes.front().At({x, 0.25}), votes.back().At({x, 0.25}), 1e-3) << x;
  }
  EXPECT_NEAR(votes.front().Mean(), votes.back().Mean(), 1e-5);
}

// A wall weighs no more than its length in steps of 2 m; what stands alone weighs 1.
TEST(MakeVotingPoints, NeighboursShareTheirWeight) {
  const VotingPoints points = MakeVotingPoints({{10.1, 0.1}, {10.7, 0.1}, {30.1, 5.1}}, 100);
  std::vector<double> weights = points.weights;
  std::sort(weights.begin(), weights.end());
  EXPECT_EQ(weights, (std::vector<double>{0.5, 0.5, 1.0}));
}

TEST(SpreadOut, TwoScansKeepTheSameSquares) {
  Points first, second;
  for (int i = 0; i < 2000; ++i) first.emplace_back(0.51 * (i % 100) - 20.0, 0.52 * (i / 100));
  for (auto p = first.rbegin(); p != first.rend(); ++p) second.push_back(*p);
  const std::vector<std::size_t> a = SpreadOut(first, 50), b = SpreadOut(second, 50);
  ASSERT_EQ(a.size(), 50u);
  ASSERT_EQ(b.size(), 50u);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(first[a[i]], second[b[i]]);
}

TEST(MakeVotingPoints, OnePointOfASquareAndNoneFarAway) {
  const Points points = {{10.1, 0.1}, {10.2, 0.2}, {81.0, 0.0}, {30.1, 5.1}, {1e300, 0.0}};
  EXPECT_EQ(MakeVotingPoints(points, 100).positions.size(), 2u);
  EXPECT_EQ(MakeVotingPoints(points, 1).positions.size(), 1u);
}

}  // namespace
}  // namespace radive
