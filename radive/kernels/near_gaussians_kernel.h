// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// The search among GaussianColumns, for the files that define RADIVE_KERNELS.

#pragma once

#include "radive/kernels/near_gaussians.h"
#include "radive/kernels/pack.h"

namespace radive::RADIVE_KERNELS {

inline void FindFurthest(NearFound* found) {
  int furthest = 0;
  for (int i = 1; i < found->count; ++i) {
    const double more = found->mahalanobis[i], most = found->mahalanobis[furthest];
    if (more > most || (more == most && found->index[i] > found->index[furthest])) furthest = i;
  }
  found->furthest = furthest;
}

inline void Keep(double mahalanobis, int index, int num_kept, NearFound* found) {
  int place = found->count;
  if (place == num_kept) {
    place = found->furthest;
    const double most = found->mahalanobis[place];
    if (mahalanobis > most || (mahalanobis == most && index > found->index[place])) return;
  } else {
    ++found->count;
  }
  found->mahalanobis[place] = mahalanobis;
  found->index[place] = index;
  if (found->count == num_kept) FindFurthest(found);
}

inline Pack SquaredMahalanobis(
    const GaussianColumns& columns, int k, const NearQuery& query, Pack dx, Pack dy, Pack dz) {
  const double* S = query.covariance;
  const Pack xx = S[0] + Load(columns.covariance[0] + k);
  const Pack xy = S[1] + Load(columns.covariance[1] + k);
  const Pack xz = S[2] + Load(columns.covariance[2] + k);
  const Pack yy = S[3] + Load(columns.covariance[3] + k);
  const Pack yz = S[4] + Load(columns.covariance[4] + k);
  const Pack zz = S[5] + Load(columns.covariance[5] + k);
  const Pack cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
  const Pack cyy = xx * zz - xz * xz, cyz = xy * xz - xx * yz, czz = xx * yy - xy * xy;
  const Pack along = dx * (cxx * dx + cxy * dy + cxz * dz) + dy * (cxy * dx + cyy * dy + cyz * dz) +
                     dz * (cxz * dx + cyz * dy + czz * dz);
  return along / (xx * cxx + xy * cxy + xz * cxz);
}

// Adds the pairs among the rows from `begin` to `end`.
inline void FindNear(
    const GaussianColumns& columns, int begin, int end, const NearQuery& query, NearFound* found) {
  const Pack max_squared = All(query.max_distance * query.max_distance);
  const bool keeps_all = query.num_kept == 0;
  // The squared Mahalanobis distance is at least the squared distance over the largest variances;
  // the little more is for rounding.
  constexpr double kRounding = 1.0 + 1e-9;
  double limit = __builtin_inf();
  for (int k = begin; k < end; k += 4) {
    if (!keeps_all && found->count == query.num_kept) {
      limit = found->mahalanobis[found->furthest];
    }
    const Pack dx = query.mean[0] - Load(columns.mean[0] + k);
    const Pack dy = query.mean[1] - Load(columns.mean[1] + k);
    const Pack dz = query.mean[2] - Load(columns.mean[2] + k);
    const Pack squared = dx * dx + dy * dy + dz * dz;
    const Pack variance = query.max_variance + Load(columns.max_variance + k);
    const Bits is_row = Bits{k, k + 1, k + 2, k + 3} < end;
    Bits is_pair = is_row & (squared <= max_squared) & (squared <= limit * kRounding * variance);
    if (Which(is_pair) == 0) continue;
    const Pack beyond = Sqrt(squared) - query.slack;
    is_pair &= (beyond <= 0.0) | (beyond * beyond <= query.max_mahalanobis * variance);
    int which = Which(is_pair);
    if (which == 0) continue;
    if (keeps_all) {
      for (; which != 0; which &= which - 1) {
        found->index[found->count++] =
            columns.index[k + __builtin_ctz(static_cast<unsigned>(which))];
      }
      continue;
    }
    const Pack m = SquaredMahalanobis(columns, k, query, dx, dy, dz);
    for (which &= Which(m <= limit); which != 0; which &= which - 1) {
      const int lane = __builtin_ctz(static_cast<unsigned>(which));
      Keep(m[lane], columns.index[k + lane], query.num_kept, found);
    }
  }
}

}  // namespace radive::RADIVE_KERNELS
