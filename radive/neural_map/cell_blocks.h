// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "radive/util/cell_key.h"

namespace radive {

// A number for each cell of a grid that has one, in blocks of 4 x 4 x 4 with a bit for each cell
// that does: most of the cells around a position have none, and eight lookups find all 125.
class CellBlocks {
 public:
  // Half width of the cube of cells that ForEachAround() looks at.
  static constexpr std::int64_t kReach = 2;

  // Of a cell; -1: none.
  std::int32_t Find(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const auto at = block_of_.find(BlockKey(x, y, z));
    if (at == block_of_.end()) return -1;
    const Block& block = blocks_[at->second];
    const unsigned place = Place(x, y, z);
    return (block.has_number >> place & 1U) != 0 ? block.numbers[place] : -1;
  }

  void Set(std::int64_t x, std::int64_t y, std::int64_t z, std::int32_t number) {
    const auto [at, is_new] =
        block_of_.try_emplace(BlockKey(x, y, z), static_cast<std::uint32_t>(blocks_.size()));
    if (is_new) blocks_.emplace_back();
    Block& block = blocks_[at->second];
    const unsigned place = Place(x, y, z);
    block.has_number |= std::uint64_t{1} << place;
    block.numbers[place] = number;
  }

  void Clear() {
    block_of_.clear();
    blocks_.clear();
  }

  // Calls function(number) for the cells within kReach on each axis, which lie in two blocks an
  // axis.
  template <typename Function>
  void ForEachAround(std::int64_t x, std::int64_t y, std::int64_t z, Function&& function) const {
    const std::int64_t x0 = (x - kReach) >> 2, y0 = (y - kReach) >> 2, z0 = (z - kReach) >> 2;
    for (int k = 0; k < 2; ++k) {
      for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
          const auto at = block_of_.find(CellKey(x0 + i, y0 + j, z0 + k));
          if (at == block_of_.end()) continue;
          const Block& block = blocks_[at->second];
          std::uint64_t cells =
              block.has_number & kAlongX[i][x & 3] & kAlongY[j][y & 3] & kAlongZ[k][z & 3];
          for (; cells != 0; cells &= cells - 1) {
            function(block.numbers[static_cast<std::size_t>(__builtin_ctzll(cells))]);
          }
        }
      }
    }
  }

 private:
  struct Block {
    std::uint64_t has_number = 0;
    std::array<std::int32_t, 64> numbers;
  };

  // The cells in reach of one, in the first and in the second block along an axis, by its place in
  // its own block: bits of 4 cells along x, repeated for each y and z, and so on.
  static constexpr std::uint64_t kEachRow = 0x1111111111111111u, kEachLayer = 0x0001000100010001u;
  static constexpr std::uint64_t kAlongX[2][4] = {
      {0xCu * kEachRow, 0x8u * kEachRow, 0xFu * kEachRow, 0xEu * kEachRow},
      {0x7u * kEachRow, 0xFu * kEachRow, 0x1u * kEachRow, 0x3u * kEachRow}};
  static constexpr std::uint64_t kAlongY[2][4] = {
      {0xFF00u * kEachLayer, 0xF000u * kEachLayer, 0xFFFFu * kEachLayer, 0xFFF0u * kEachLayer},
      {0x0FFFu * kEachLayer, 0xFFFFu * kEachLayer, 0x000Fu * kEachLayer, 0x00FFu * kEachLayer}};
  static constexpr std::uint64_t kAlongZ[2][4] = {
      {0xFFFFFFFF00000000u, 0xFFFF000000000000u, 0xFFFFFFFFFFFFFFFFu, 0xFFFFFFFFFFFF0000u},
      {0x0000FFFFFFFFFFFFu, 0xFFFFFFFFFFFFFFFFu, 0x000000000000FFFFu, 0x00000000FFFFFFFFu}};

  static std::uint64_t BlockKey(std::int64_t x, std::int64_t y, std::int64_t z) {
    return CellKey(x >> 2, y >> 2, z >> 2);
  }
  static unsigned Place(std::int64_t x, std::int64_t y, std::int64_t z) {
    return static_cast<unsigned>((x & 3) | ((y & 3) << 2) | ((z & 3) << 4));
  }

  tsl::robin_map<std::uint64_t, std::uint32_t, CellKeyHash> block_of_;
  std::vector<Block> blocks_;
};

}  // namespace radive
