// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/cell_blocks.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "radive/util/random.h"

namespace radive {
namespace {

using Cell = std::array<std::int64_t, 3>;

TEST(CellBlocks, FindsWhatWasSetAround) {
  Random random(1);
  CellBlocks blocks;
  std::map<Cell, std::int32_t> all;
  const auto coordinate = [&random] { return static_cast<std::int64_t>(random.Index(15)) - 7; };
  for (int i = 0; i < 600; ++i) {
    const Cell cell = {coordinate(), coordinate(), coordinate()};
    blocks.Set(cell[0], cell[1], cell[2], i);
    all[cell] = i;  // the last one counts
  }
  for (int i = 0; i < 300; ++i) {
    const Cell centre = {coordinate(), coordinate(), coordinate()};
    std::multiset<std::int32_t> expected, found;
    for (const auto& [cell, number] : all) {
      bool is_around = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        is_around &= std::abs(cell[axis] - centre[axis]) <= CellBlocks::kReach;
      }
      if (is_around) expected.insert(number);
    }
    blocks.ForEachAround(
        centre[0], centre[1], centre[2], [&found](std::int32_t number) { found.insert(number); });
    EXPECT_EQ(found, expected);
    const auto at = all.find(centre);
    EXPECT_EQ(blocks.Find(centre[0], centre[1], centre[2]), at == all.end() ? -1 : at->second);
  }
  blocks.Clear();
  EXPECT_EQ(blocks.Find(all.begin()->first[0], all.begin()->first[1], all.begin()->first[2]), -1);
}

}  // namespace
}  // namespace radive
