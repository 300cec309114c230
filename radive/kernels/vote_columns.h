// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// Points of a scan in the plane, in the cells of a grid of displacements. Seven more must be there
// to be read.
struct VoteColumns {
  const float* x;  // [cells]
  const float* y;
  const float* weight;
};

// Votes of pairs of points for displacements, on grids of float: a pair lies in the cell of the
// difference before - after. Points meet within boxes of 2 cells along the line of sight and 6
// across.
struct VoteGrids {
  static constexpr int kCells = 102;          // that count, along an axis
  static constexpr int kPlaces = kCells - 5;  // where a whole box around lies on the grid

  // Around those that count are some that do not.
  static constexpr int kLeft = 5, kBelow = 1;
  static constexpr int kStride = 128;                             // from row to row
  static constexpr int kElsewhere = (kBelow + kCells) * kStride;  // a cell for all that lie outside
  static constexpr int kSize = kElsewhere + kStride;

  float* ahead;  // kSize: of points whose line of sight is nearer to the x axis
  float* aside;  // kSize: of the others
};

}  // namespace radive
