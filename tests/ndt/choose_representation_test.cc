// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/choose_representation.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace radive {
namespace {

using Representation = NdtOptions::Representation;

// `count` returns, `per_voxel` of them in each voxel of 2 m x 2 m x 1 m along x.
std::vector<RadarReturn> Returns(int count, int per_voxel) {
  std::vector<RadarReturn> returns(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    returns[static_cast<std::size_t>(i)].position = {2.0 * (i / per_voxel) + 1.0, 1.0, 0.5};
  }
  return returns;
}

Representation Choice(int count, int per_voxel, std::string* reason) {
  return ChooseRepresentation(Returns(count, per_voxel), NdtOptions(), reason);
}

TEST(ChooseRepresentation, ByNumberAndDensity) {
  std::string reason;
  EXPECT_EQ(Choice(998, 2, &reason), Representation::kPoint);
  EXPECT_EQ(reason,
            "ndt.representation point, for the first scan has 998 static returns, 2.0 to a voxel");
  EXPECT_EQ(Choice(1000, 2, &reason), Representation::kVoxel);
  EXPECT_EQ(reason,
            "ndt.representation voxel, for the first scan has 1000 static returns, 2.0 to a voxel");
  EXPECT_EQ(Choice(1000, 1, &reason), Representation::kPoint) << "spread thinly";
  EXPECT_EQ(Choice(3999, 1, &reason), Representation::kPoint);
  EXPECT_EQ(Choice(4000, 1, &reason), Representation::kVoxel) << "too many for points";
  EXPECT_EQ(Choice(400, 40, &reason), Representation::kPoint) << "a sparse radar in a small room";
  EXPECT_EQ(Choice(0, 1, &reason), Representation::kPoint);
}

// Voxels that the option leaves out as too thin count all the same.
TEST(ChooseRepresentation, CountsThinVoxels) {
  NdtOptions options;
  options.min_points = 3;
  std::string reason;
  EXPECT_EQ(ChooseRepresentation(Returns(1000, 1), options, &reason), Representation::kPoint);
  EXPECT_NE(reason.find("1.0 to a voxel"), std::string::npos) << reason;
}

}  // namespace
}  // namespace radive
