// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>

namespace radive {

// Integer cell coordinates of a grid packed into one key, 21 bits each: +-1,048,576 cells. Cells
// further out alias others, which costs a few wasted comparisons and nothing else.
inline std::uint64_t CellKey(std::int64_t x, std::int64_t y, std::int64_t z) {
  constexpr std::uint64_t kMask = (1u << 21) - 1;
  return (static_cast<std::uint64_t>(x) & kMask) | ((static_cast<std::uint64_t>(y) & kMask) << 21) |
         ((static_cast<std::uint64_t>(z) & kMask) << 42);
}

// Of already floored coordinates.
inline std::uint64_t CellKey(double x, double y, double z) {
  return CellKey(
      static_cast<std::int64_t>(x), static_cast<std::int64_t>(y), static_cast<std::int64_t>(z));
}

// The coordinates that CellKey() has packed, of the cells that it tells apart.
inline Eigen::Vector3i CellOfKey(std::uint64_t key) {
  const auto coordinate = [key](int shift) {
    const int bits = static_cast<int>((key >> shift) & ((1u << 21) - 1));
    return bits < (1 << 20) ? bits : bits - (1 << 21);
  };
  return {coordinate(0), coordinate(21), coordinate(42)};
}

// Mixes the packed coordinates (finaliser of SplitMix64): robin maps want good low bits.
struct CellKeyHash {
  std::size_t operator()(std::uint64_t key) const {
    key = (key ^ (key >> 30)) * 0xBF58476D1CE4E5B9ull;
    key = (key ^ (key >> 27)) * 0x94D049BB133111EBull;
    return static_cast<std::size_t>(key ^ (key >> 31));
  }
};

}  // namespace radive
