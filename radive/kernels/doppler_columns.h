// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// Range rates that are linear in a velocity, a column for each number of a return:
// residual = v_doppler + direction . velocity, of the multiple of `span` that is nearest to zero.
struct DopplerColumns {
  const double* direction[3];  // in the coordinates that the velocity has; the last may be nullptr
  const double* v_doppler;     // [m/s]
  const double* weight;        // nullptr where it does not matter
  int size = 0;
  double span = 0.0;  // [m/s]; 0: the range rates have no such ambiguity
};

// Returns count whose residual is at most gate times noise [m/s], with noise^2 = 1 + (ratio times
// the velocity across the direction)^2.
struct DopplerGate {
  double velocity[3];  // [m/s]
  double gate;         // [m/s]
  double ratio;        // [s/m]
};

// Sums over the returns that count, with w = weight / noise^2. Upper triangles, row by row.
struct DopplerSums {
  double equations[10];  // of w a a^T with a = (direction, v_doppler nearest to what is expected)
  double weights;        // of w
  double squares;        // of residual^2
  int count;

  // Filled with the rest:
  double scatter[6];     // of (w residual)^2 d d^T
  double noise[6];       // of (w noise)^2 d d^T
  double directions[6];  // of d d^T
  int num_at_edge;       // returns, also beyond the gate, within a quarter of it from its edge
};

}  // namespace radive
