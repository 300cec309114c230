// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "radive/kernels/doppler_columns.h"
#include "radive/kernels/ndt_packs.h"
#include "radive/kernels/near_gaussians.h"
#include "radive/kernels/vote_columns.h"

namespace radive {

// The loops that most of the time goes into, on plain arrays, see kernels.h.
struct Kernels {
  const char* name;

  // At the pose with the rotation R (rows one after the other) and the translation t.
  void (*sum_ndt_pairs)(const NdtPacks& packs, const double* R, const double* t, NdtSums* sums);

  // Adds to `found` the pairs of a scan Gaussian among the rows from `begin` to `end`.
  void (*find_near)(
      const GaussianColumns& columns, int begin, int end, const NearQuery& query, NearFound* found);

  // Returns with a residual of at most `gate`; `velocity` as many numbers as there are directions.
  int (*count_within_gate)(const DopplerColumns& columns, const double* velocity, double gate);

  // `inliers` gets the returns that count, a bit each, four a byte. `with_rest`: fills all of
  // `sums`.
  void (*sum_within_gate)(const DopplerColumns& columns,
                          const DopplerGate& gate,
                          bool with_rest,
                          DopplerSums* sums,
                          unsigned char* inliers);

  // Of a point after with the points `begin` to `end` before, none of which is more than four cells
  // to the left or right of the grid; (x, y): the lower left corner of the grid.
  void (*add_votes)(
      const VoteColumns& before, int begin, int end, float x, float y, float weight, float* votes);

  // Largest so far of the votes in the boxes of VoteGrids, kPlaces rows of kStride; the grids are
  // empty afterwards.
  void (*raise_to_boxes)(const VoteGrids& grids, float* most);
};

const Kernels* PlainKernels();
const Kernels* Avx2Kernels();  // nullptr where this processor cannot run them

}  // namespace radive
