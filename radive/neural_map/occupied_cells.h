// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tsl/robin_map.h>

#include <array>
#include <cstddef>
#include <cstdint>

#include "radive/util/cell_key.h"

namespace radive {

// Which cells of a grid hold something, a bit each in blocks of 4 x 4 x 4: most of the cells around
// a position are empty, and eight lookups tell so instead of 125.
class OccupiedCells {
 public:
  // Half width of the cube of cells that Around answers for.
  static constexpr std::int64_t kReach = 2;

  void Insert(std::int64_t x, std::int64_t y, std::int64_t z) {
    blocks_[BlockKey(x, y, z)] |= CellBit(x, y, z);
  }
  void Clear() { blocks_.clear(); }

  // The cells within kReach of one on each axis, which lie in two blocks an axis.
  class Around {
   public:
    Around(const OccupiedCells& cells, std::int64_t x, std::int64_t y, std::int64_t z)
        : x_((x - kReach) >> 2), y_((y - kReach) >> 2), z_((z - kReach) >> 2) {
      for (std::size_t i = 0; i < bits_.size(); ++i) {
        const auto n = static_cast<std::int64_t>(i);
        const auto at =
            cells.blocks_.find(CellKey(x_ + (n & 1), y_ + ((n >> 1) & 1), z_ + (n >> 2)));
        bits_[i] = at == cells.blocks_.end() ? 0 : at->second;
      }
    }

    bool IsOccupied(std::int64_t x, std::int64_t y, std::int64_t z) const {
      const std::int64_t i = ((x >> 2) - x_) | (((y >> 2) - y_) << 1) | (((z >> 2) - z_) << 2);
      return (bits_[static_cast<std::size_t>(i)] & CellBit(x, y, z)) != 0;
    }

   private:
    const std::int64_t x_, y_, z_;  // of the first block
    std::array<std::uint64_t, 8> bits_;
  };

 private:
  static std::uint64_t BlockKey(std::int64_t x, std::int64_t y, std::int64_t z) {
    return CellKey(x >> 2, y >> 2, z >> 2);
  }
  static std::uint64_t CellBit(std::int64_t x, std::int64_t y, std::int64_t z) {
    return std::uint64_t{1} << ((x & 3) | ((y & 3) << 2) | ((z & 3) << 4));
  }

  tsl::robin_map<std::uint64_t, std::uint64_t, CellKeyHash> blocks_;
};

}  // namespace radive
