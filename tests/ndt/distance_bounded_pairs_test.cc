// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/distance_bounded_pairs.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "tests/synthetic_scene.h"

namespace radive {
namespace {

using PairSet = std::set<std::pair<int, int>>;

PairSet Set(const std::vector<NdtPair>& pairs) {
  PairSet set;
  for (const NdtPair& pair : pairs) {
    EXPECT_TRUE(set.emplace(pair.scan, pair.submap).second) << "pair found twice";
  }
  return set;
}

void ExpectSorted(const std::vector<NdtPair>& pairs) {
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end(), [](const NdtPair& a, const NdtPair& b) {
    return std::make_pair(a.scan, a.submap) < std::make_pair(b.scan, b.submap);
  }));
}

double Mahalanobis(const Gaussian3& a, const Gaussian3& b, const Rigid3& T) {
  const Eigen::Matrix3d R = T.RotationMatrix();
  const Eigen::Vector3d d = T * a.mean - b.mean;
  const Eigen::Matrix3d S = R * a.covariance * R.transpose() + b.covariance;
  return d.dot(S.inverse() * d);
}

struct Clouds {
  std::vector<Gaussian3> scan, submap;
  Rigid3 T_submap_radar;
};

Clouds RandomClouds(int num_scan, int num_submap, Random* random) {
  Clouds clouds;
  clouds.scan = testing::RandomGaussians(num_scan, {12.0, 12.0, 3.0}, random);
  clouds.submap = testing::RandomGaussians(num_submap, {15.0, 15.0, 3.0}, random);
  clouds.T_submap_radar = testing::RandomRigid3(3.0, 6.0, random);
  return clouds;
}

// Distance bound alone.
PairOptions DistanceOnly(double d_max) {
  PairOptions options;
  options.d_max = d_max;
  options.prune = false;
  options.max_neighbors = 0;
  return options;
}

TEST(PairSearch, DistanceBoundEqualsBruteForce) {
  Random random(1);
  for (int i = 0; i < 30; ++i) {
    const Clouds clouds = RandomClouds(40, 150, &random);
    const double d_max = random.Uniform(0.3, 12.0);
    PairSet expected;
    for (std::size_t a = 0; a < clouds.scan.size(); ++a) {
      for (std::size_t b = 0; b < clouds.submap.size(); ++b) {
        const Eigen::Vector3d d =
            clouds.T_submap_radar * clouds.scan[a].mean - clouds.submap[b].mean;
        if (d.norm() <= d_max) expected.emplace(static_cast<int>(a), static_cast<int>(b));
      }
    }
    const std::vector<NdtPair> pairs = PairSearch(clouds.submap)
                                           .Find(clouds.scan,
                                                 clouds.T_submap_radar,
                                                 DistanceOnly(d_max),
                                                 /*slack=*/0.5);
    EXPECT_EQ(Set(pairs), expected);
    ExpectSorted(pairs);
  }
}

// The rule of the comment in PairOptions, pair by pair.
TEST(PairSearch, PruningEqualsItsRule) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const Clouds clouds = RandomClouds(40, 150, &random);
    PairOptions options = DistanceOnly(5.0);
    options.prune = true;
    options.max_mahalanobis = random.Uniform(2.0, 12.0);
    const double slack = random.Uniform(0.0, 1.0);
    PairSet expected;
    for (std::size_t a = 0; a < clouds.scan.size(); ++a) {
      for (std::size_t b = 0; b < clouds.submap.size(); ++b) {
        const double distance =
            (clouds.T_submap_radar * clouds.scan[a].mean - clouds.submap[b].mean).norm();
        const double excess = std::max(0.0, distance - slack);
        const double variances = LargestEigenvalue(clouds.scan[a].covariance) +
                                 LargestEigenvalue(clouds.submap[b].covariance);
        if (distance <= options.d_max && excess * excess <= options.max_mahalanobis * variances) {
          expected.emplace(static_cast<int>(a), static_cast<int>(b));
        }
      }
    }
    const std::vector<NdtPair> pairs =
        PairSearch(clouds.submap).Find(clouds.scan, clouds.T_submap_radar, options, slack);
    EXPECT_EQ(Set(pairs), expected);
  }
}

// What pruning promises: a pair that is left out stays beyond max_mahalanobis wherever the pose
// moves its scan mean by no more than the slack, and however it turns.
TEST(PairSearch, PrunedPairsStayOutOfReachWithinTheSlack) {
  Random random(3);
  constexpr double kSlack = 0.7;
  int num_dropped = 0, num_nearly_reached = 0;
  for (int i = 0; i < 10; ++i) {
    const Clouds clouds = RandomClouds(20, 80, &random);
    PairOptions options = DistanceOnly(1000.0);
    options.prune = true;
    const PairSet kept =
        Set(PairSearch(clouds.submap).Find(clouds.scan, clouds.T_submap_radar, options, kSlack));
    for (std::size_t a = 0; a < clouds.scan.size(); ++a) {
      for (std::size_t b = 0; b < clouds.submap.size(); ++b) {
        if (kept.count({static_cast<int>(a), static_cast<int>(b)}) > 0) continue;
        ++num_dropped;
        const Eigen::Vector3d mean = clouds.T_submap_radar * clouds.scan[a].mean;
        const Eigen::Vector3d towards = (clouds.submap[b].mean - mean).normalized();
        for (int k = 0; k < 8; ++k) {
          // Turned about the radar, with the mean brought to within the slack of where it was; the
          // first draws go straight for the submap Gaussian.
          Rigid3 T;
          T.rotation =
              testing::RandomRigid3(3.0, 0.0, &random).rotation * clouds.T_submap_radar.rotation;
          const Eigen::Vector3d shift =
              k < 4 ? Eigen::Vector3d(kSlack * towards)
                    : Eigen::Vector3d(random.Uniform(0.0, kSlack) * testing::RandomUnit3(&random));
          T.translation = mean + shift - T.rotation * clouds.scan[a].mean;
          const double m = Mahalanobis(clouds.scan[a], clouds.submap[b], T);
          EXPECT_GT(m, options.max_mahalanobis * (1.0 - 1e-9));
          if (m < 1.5 * options.max_mahalanobis) ++num_nearly_reached;
        }
      }
    }
  }
  EXPECT_GT(num_dropped, 1000);
  EXPECT_GT(num_nearly_reached, 10) << "the bound should be worth something";
}

TEST(PairSearch, KeepsTheNearestInMahalanobisDistance) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const Clouds clouds = RandomClouds(30, 300, &random);
    PairOptions options = DistanceOnly(8.0);
    const PairSearch search(clouds.submap);
    const PairSet all = Set(search.Find(clouds.scan, clouds.T_submap_radar, options, 0.5));
    options.max_neighbors = 4;
    const std::vector<NdtPair> pairs =
        search.Find(clouds.scan, clouds.T_submap_radar, options, 0.5);
    ExpectSorted(pairs);
    const PairSet kept = Set(pairs);
    for (int a = 0; a < 30; ++a) {
      std::vector<std::pair<double, int>> ranked;
      for (const auto& [scan, submap] : all) {
        if (scan != a) continue;
        ranked.emplace_back(Mahalanobis(clouds.scan[static_cast<std::size_t>(a)],
                                        clouds.submap[static_cast<std::size_t>(submap)],
                                        clouds.T_submap_radar),
                            submap);
      }
      std::sort(ranked.begin(), ranked.end());
      for (std::size_t k = 0; k < ranked.size(); ++k) {
        EXPECT_EQ(kept.count({a, ranked[k].second}), k < 4 ? 1u : 0u);
      }
    }
  }
}

// Gaussians that come and go leave what a new search over the same submap has, also where strips
// empty, and where many have the same coordinates.
TEST(PairSearch, UpdatedEqualsBuiltAnew) {
  Random random(8);
  std::vector<Gaussian3> submap = testing::RandomGaussians(50, {15.0, 15.0, 3.0}, &random);
  PairSearch updated(submap);
  for (int i = 0; i < 40; ++i) {
    const Clouds clouds = RandomClouds(30, 1 + static_cast<int>(random.Index(60)), &random);
    const std::uint64_t one_in = i % 10 == 9 ? 1 : 1 + random.Index(6);
    std::vector<Gaussian3> next;
    std::vector<int> moved;
    for (const Gaussian3& gaussian : submap) {
      const bool is_gone = random.Index(one_in) == 0;
      moved.push_back(is_gone ? -1 : static_cast<int>(next.size()));
      if (!is_gone) next.push_back(gaussian);
    }
    next.insert(next.end(), clouds.submap.begin(), clouds.submap.end());
    next.push_back(next.front());
    submap = next;
    updated.Update(submap, moved);
    for (const int max_neighbors : {0, 5}) {
      PairOptions options = DistanceOnly(6.0);
      options.max_neighbors = max_neighbors;
      const auto find = [&](const PairSearch& search) {
        std::vector<std::pair<int, int>> pairs;
        for (const NdtPair& pair :
             search.Find(clouds.scan, clouds.T_submap_radar, options, /*slack=*/0.5)) {
          pairs.emplace_back(pair.scan, pair.submap);
        }
        return pairs;
      };
      EXPECT_EQ(find(updated), find(PairSearch(submap)));
    }
  }
}

// Full NDT pays no heed to any bound.
TEST(PairSearch, NoBoundGivesAllPairs) {
  Random random(5);
  const Clouds clouds = RandomClouds(7, 11, &random);
  PairOptions options;
  options.bound = PairOptions::Bound::kNone;
  options.d_max = 0.1;
  const std::vector<NdtPair> pairs =
      PairSearch(clouds.submap).Find(clouds.scan, clouds.T_submap_radar, options, 0.0);
  EXPECT_EQ(Set(pairs).size(), 77u);
  ExpectSorted(pairs);
}

TEST(PairSearch, EmptySidesGiveNoPairs) {
  Random random(6);
  const Clouds clouds = RandomClouds(5, 5, &random);
  const std::vector<Gaussian3> nothing;
  for (const PairOptions::Bound bound :
       {PairOptions::Bound::kDistance, PairOptions::Bound::kNone}) {
    PairOptions options;
    options.bound = bound;
    EXPECT_TRUE(PairSearch(nothing).Find(clouds.scan, Rigid3(), options, 1.0).empty());
    EXPECT_TRUE(PairSearch(clouds.submap).Find(nothing, Rigid3(), options, 1.0).empty());
  }
}

// On cell borders, with negative coordinates, and a thousand kilometres out.
TEST(PairSearch, FindsNeighboursAcrossCells) {
  for (const double offset : {0.0, -2.0, 4.0, 1e6, -1e6}) {
    std::vector<Gaussian3> submap(4), scan(1);
    submap[0].mean = {offset + 0.01, offset, 0.0};
    submap[1].mean = {offset - 0.01, offset, 0.0};
    submap[2].mean = {offset, offset - 0.01, 50.0};
    submap[3].mean = {offset, offset - 0.01, 0.0};
    const Rigid3 T{Eigen::Quaterniond::Identity(), {offset, offset, 0.0}};
    const PairSet expected = {{0, 0}, {0, 1}, {0, 3}};
    EXPECT_EQ(Set(PairSearch(submap).Find(scan, T, DistanceOnly(1.0), 0.0)), expected) << offset;
  }
}

TEST(LargestEigenvalue, OfKnownMatrices) {
  Eigen::Matrix3d m;
  m << 2.0, 1.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 0.5;
  EXPECT_NEAR(LargestEigenvalue(m), 3.0, 1e-12);
  m(2, 2) = 3.5;
  EXPECT_NEAR(LargestEigenvalue(m), 3.5, 1e-12);
  EXPECT_NEAR(LargestEigenvalue(0.05 * Eigen::Matrix3d::Identity()), 0.05, 1e-15);
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d axes =
        QuaternionFromRotationVector(3.0 * testing::RandomNormal3(&random)).toRotationMatrix();
    const Eigen::Vector3d values(1e-4, 0.3, 0.3 + 1e-6 * i);
    EXPECT_NEAR(LargestEigenvalue(axes * values.asDiagonal() * axes.transpose()), values.z(), 1e-8);
  }
}

}  // namespace
}  // namespace radive
