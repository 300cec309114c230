// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/voxel_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "radive/ndt/gaussian_builder.h"
#include "radive/util/random.h"

namespace radive {
namespace {

std::vector<Gaussian3> Sorted(std::vector<Gaussian3> gaussians) {
  std::sort(gaussians.begin(), gaussians.end(), [](const Gaussian3& a, const Gaussian3& b) {
    return std::lexicographical_compare(a.mean.begin(), a.mean.end(), b.mean.begin(), b.mean.end());
  });
  return gaussians;
}

// A drive far from the origin: voxels fill, empty, and are used again.
TEST(VoxelWindow, HasTheVoxelsOfTheLastKeyframes) {
  NdtOptions options;
  options.min_points = 3;
  VoxelWindow window(options);
  std::deque<std::vector<Eigen::Vector3d>> points;
  std::deque<std::vector<double>> weights;
  Random random(2);
  std::vector<Gaussian3> before;
  for (int i = 0; i < 25; ++i) {
    points.emplace_back();
    weights.emplace_back();
    for (int k = 0; k < 200; ++k) {
      points.back().emplace_back(5000.0 + i % 6 + random.Uniform(-4.0, 4.0),
                                 random.Uniform(-4.0, 4.0),
                                 random.Uniform(-1.0, 1.0));
      weights.back().push_back(random.Uniform(0.1, 1.0));
    }
    if (points.size() > 4) {
      points.pop_front();
      weights.pop_front();
    }
    const std::vector<int> moved = window.AddKeyframe(points.back(), weights.back(), 4);
    ASSERT_EQ(moved.size(), before.size());
    for (std::size_t k = 0; k < moved.size(); ++k) {
      if (moved[k] < 0) continue;
      EXPECT_EQ(window.gaussians()[static_cast<std::size_t>(moved[k])].mean, before[k].mean);
    }
    before = window.gaussians();

    std::vector<Eigen::Vector3d> all_points;
    std::vector<double> all_weights;
    for (std::size_t k = 0; k < points.size(); ++k) {
      all_points.insert(all_points.end(), points[k].begin(), points[k].end());
      all_weights.insert(all_weights.end(), weights[k].begin(), weights[k].end());
    }
    const std::vector<Gaussian3> expected =
        Sorted(GaussiansOfVoxels(all_points, all_weights, options));
    const std::vector<Gaussian3> found = Sorted(window.gaussians());
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_LE((found[k].mean - expected[k].mean).norm(), 1e-11);
      EXPECT_LE((found[k].covariance - expected[k].covariance).norm(), 1e-11);
      EXPECT_NEAR(found[k].weight, expected[k].weight, 1e-12);
      EXPECT_EQ(found[k].count, expected[k].count);
    }
  }
}

}  // namespace
}  // namespace radive
