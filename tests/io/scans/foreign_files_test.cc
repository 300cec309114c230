// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/scans/foreign_files.h"

#include <gtest/gtest.h>

namespace radive {
namespace {

using Names = std::vector<std::string>;

TEST(ForeignFiles, NamesWithoutANumberBesideNumberedScans) {
  Names names = {"0001.csv", "0002.csv", "0003.csv", "map.csv", "poses.csv"};
  EXPECT_EQ(TakeOutForeign(nullptr, &names), (Names{"map.csv", "poses.csv"}));
  EXPECT_EQ(names, (Names{"0001.csv", "0002.csv", "0003.csv"}));
}

// Names with another number are asked for: they may be scans.
TEST(ForeignFiles, OtherNumberedNamesAreLookedInto) {
  Names names = {"1700000000.1.csv", "1700000000.25.csv", "gt_2023.csv", "radar_7.csv"};
  const auto holds_points = [](const std::string& name) { return name != "gt_2023.csv"; };
  EXPECT_EQ(TakeOutForeign(holds_points, &names), Names{"gt_2023.csv"});
  EXPECT_EQ(names, (Names{"1700000000.1.csv", "1700000000.25.csv", "radar_7.csv"}));
  EXPECT_EQ(TakeOutForeign(nullptr, &names), Names{}) << "without a test they stay";
}

// Where no two names are alike, and where there is one file.
TEST(ForeignFiles, NamesThatAreAllDifferent) {
  Names names = {"a.csv", "imu.csv", "scan.csv"};
  EXPECT_EQ(TakeOutForeign(nullptr, &names), Names{});
  const auto holds_points = [](const std::string& name) { return name != "imu.csv"; };
  EXPECT_EQ(TakeOutForeign(holds_points, &names), Names{"imu.csv"});
  EXPECT_EQ(names, (Names{"a.csv", "scan.csv"}));
  names = {"imu.csv"};
  EXPECT_EQ(TakeOutForeign(holds_points, &names), Names{}) << "the user named it";
}

}  // namespace
}  // namespace radive
