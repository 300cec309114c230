// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The votes of pairs of points, for the files that define RADIVE_KERNELS.

#pragma once

#include "radive/kernels/vote_columns.h"

namespace radive::RADIVE_KERNELS {

using Floats = float __attribute__((vector_size(32)));
using Whole = int __attribute__((vector_size(32)));

inline Floats LoadFloats(const float* eight) {
  Floats floats;
  __builtin_memcpy(&floats, eight, sizeof(floats));
  return floats;
}

inline void StoreFloats(Floats floats, float* eight) {
  __builtin_memcpy(eight, &floats, sizeof(floats));
}

// A point of the scan after with the points `begin` to `end` before, none of which is more than
// four cells to the left or right of the grid; (x, y): the lower left corner of the grid.
inline void AddVotes(
    const VoteColumns& before, int begin, int end, float x, float y, float weight, float* votes) {
  using Unsigned = unsigned int __attribute__((vector_size(32)));
  const Unsigned elsewhere = Unsigned{} + static_cast<unsigned int>(VoteGrids::kElsewhere);
  x -= static_cast<float>(VoteGrids::kLeft);
  y -= static_cast<float>(VoteGrids::kBelow);
  // Some points first get their cells, then vote: it is slow to take eight numbers out of a
  // register.
  constexpr int kSome = 64;
  alignas(32) unsigned int cells[kSome];
  alignas(32) float weights[kSome];
  for (; begin < end; begin += kSome) {
    const int count = end - begin < kSome ? end - begin : kSome;
    for (int k = 0; k < count; k += 8) {
      const Whole column = __builtin_convertvector(LoadFloats(before.x + begin + k) - x, Whole);
      const Whole row = __builtin_convertvector(LoadFloats(before.y + begin + k) - y, Whole);
      // Below the grid this is huge, as it has no sign.
      const auto cell = (Unsigned)(row * VoteGrids::kStride + column);
      const Unsigned place = cell < elsewhere ? cell : elsewhere;
      __builtin_memcpy(cells + k, &place, sizeof(place));
      StoreFloats(weight * LoadFloats(before.weight + begin + k), weights + k);
    }
#pragma GCC unroll 8
    for (int k = 0; k < count; ++k) votes[cells[k]] += weights[k];
  }
}

// Largest so far of the votes in the box around each place, of kPlaces rows of kStride. Leaves the
// grids empty.
inline void RaiseToBoxes(const VoteGrids& grids, float* most) {
  constexpr int kStride = VoteGrids::kStride;
  constexpr int kUsed = 120;      // columns that are read
  float high[kUsed], low[kUsed];  // sums over 6 rows of `ahead` and 2 of `aside`
  for (int row = 0; row < VoteGrids::kPlaces; ++row) {
    const int begin = (VoteGrids::kBelow + row) * kStride;
    for (int column = 0; column < kUsed; column += 8) {
      float* ahead = grids.ahead + begin + column;
      float* aside = grids.aside + begin + column;
      Floats sum = LoadFloats(ahead);
      for (int i = 1; i < 6; ++i) sum += LoadFloats(ahead + i * kStride);
      StoreFloats(sum, high + column);
      StoreFloats(LoadFloats(aside + 2 * kStride) + LoadFloats(aside + 3 * kStride), low + column);
      StoreFloats(Floats{}, ahead);
      StoreFloats(Floats{}, aside);
    }
    float* most_of_row = most + row * kStride;
    for (int column = 0; column < VoteGrids::kPlaces; column += 8) {
      const float* box = high + VoteGrids::kLeft + column + 2;
      Floats sum = LoadFloats(box) + LoadFloats(box + 1);
      box = low + VoteGrids::kLeft + column;
      for (int i = 0; i < 6; ++i) sum += LoadFloats(box + i);
      const Floats before = LoadFloats(most_of_row + column);
      StoreFloats(sum > before ? sum : before, most_of_row + column);
    }
  }
  for (int cell = VoteGrids::kPlaces * kStride; cell < VoteGrids::kSize; cell += 8) {
    StoreFloats(Floats{}, grids.ahead + cell);
    StoreFloats(Floats{}, grids.aside + cell);
  }
}

}  // namespace radive::RADIVE_KERNELS
