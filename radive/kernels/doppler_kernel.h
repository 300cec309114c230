// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Counts and sums over DopplerColumns, for the files that define RADIVE_KERNELS.

#pragma once

#include "radive/kernels/doppler_columns.h"
#include "radive/kernels/pack.h"

namespace radive::RADIVE_KERNELS {

// The difference to the nearest multiple of the span; inverse_span 0: the value itself.
inline Pack Wrapped(Pack value, double span, double inverse_span) {
  return value - span * RoundSmall(value * inverse_span);
}

// Calls visit(load, is_row, k) for the packs of rows from k on; load() takes a column.
template <typename Visit>
inline void ForEachPack(int size, const Visit& visit) {
  int k = 0;
  const Bits all = {-1, -1, -1, -1};
  for (; k + 4 <= size; k += 4) {
    visit([k](const double* column) { return Load(column + k); }, all, k);
  }
  if (k == size) return;
  const Bits is_row = Bits{k, k + 1, k + 2, k + 3} < size;
  const auto load = [k, size](const double* column) {
    Pack pack = {};
    for (int lane = 0; k + lane < size; ++lane) pack[lane] = column[k + lane];
    return pack;
  };
  visit(load, is_row, k);
}

template <int kDimensions>
inline int CountWithin(const DopplerColumns& columns, const double* velocity, double gate) {
  const double inverse_span = columns.span > 0.0 ? 1.0 / columns.span : 0.0;
  Bits count = {};
  ForEachPack(columns.size, [&](const auto& load, Bits is_row, int) {
    Pack residual = load(columns.v_doppler);
    for (int i = 0; i < kDimensions; ++i) residual += velocity[i] * load(columns.direction[i]);
    if (columns.span > 0.0) residual = Wrapped(residual, columns.span, inverse_span);
    count -= is_row & (residual <= gate) & (residual >= -gate);
  });
  return static_cast<int>(count[0] + count[1] + count[2] + count[3]);
}

inline int CountWithinGate(const DopplerColumns& columns, const double* velocity, double gate) {
  return columns.direction[2] == nullptr ? CountWithin<2>(columns, velocity, gate)
                                         : CountWithin<3>(columns, velocity, gate);
}

// Upper triangle of the sum of outer products.
template <int kSize>
struct OuterSum {
  Pack sum[kSize * (kSize + 1) / 2] = {};

  void Add(Pack factor, const Pack* a) {
    Pack* entry = sum;
    for (int i = 0; i < kSize; ++i) {
      const Pack row = factor * a[i];
      for (int j = i; j < kSize; ++j) *entry++ += row * a[j];
    }
  }
  void Store(double* out) const {
    for (const Pack& entry : sum) *out++ = Sum(entry);
  }
};

template <bool kAll>
inline void SumWithin(const DopplerColumns& columns,
                      const DopplerGate& gate,
                      DopplerSums* sums,
                      unsigned char* inliers) {
  const double* v = gate.velocity;
  const double inverse_span = columns.span > 0.0 ? 1.0 / columns.span : 0.0;
  const double squared_speed = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const double squared_gate = gate.gate * gate.gate, squared_ratio = gate.ratio * gate.ratio;
  OuterSum<4> equations;
  OuterSum<3> scatter, noise, directions;
  Pack weights = {}, squares = {};
  Bits count = {}, num_at_edge = {};
  ForEachPack(columns.size, [&](const auto& load, Bits is_row, int k) {
    Pack a[4] = {
        load(columns.direction[0]), load(columns.direction[1]), load(columns.direction[2])};
    const Pack along = v[0] * a[0] + v[1] * a[1] + v[2] * a[2];
    const Pack measured = load(columns.v_doppler);
    const Pack residual = Wrapped(measured + along, columns.span, inverse_span);
    a[3] = columns.span > 0.0 ? residual - along : measured;
    const Pack squared_across = squared_speed - along * along;
    const Pack squared_noise = 1.0 + squared_ratio * Where(squared_across > 0.0, squared_across);
    const Pack squared = residual * residual;
    const Pack squared_limit = squared_gate * squared_noise;
    const Bits is_inlier = is_row & (squared <= squared_limit);
    inliers[k / 4] = static_cast<unsigned char>(Which(is_inlier));
    const Pack w = Where(is_inlier, load(columns.weight) / squared_noise);
    equations.Add(w, a);
    weights += w;
    squares += Where(is_inlier, squared);
    count -= is_inlier;
    if constexpr (kAll) {
      scatter.Add(w * w * squared, a);
      noise.Add(w * w * squared_noise, a);
      directions.Add(Where(is_inlier, All(1.0)), a);
      num_at_edge -=
          is_row & (squared >= 0.5625 * squared_limit) & (squared <= 1.5625 * squared_limit);
    }
  });
  equations.Store(sums->equations);
  sums->weights = Sum(weights);
  sums->squares = Sum(squares);
  sums->count = static_cast<int>(count[0] + count[1] + count[2] + count[3]);
  if constexpr (kAll) {
    scatter.Store(sums->scatter);
    noise.Store(sums->noise);
    directions.Store(sums->directions);
    sums->num_at_edge =
        static_cast<int>(num_at_edge[0] + num_at_edge[1] + num_at_edge[2] + num_at_edge[3]);
  }
}

inline void SumWithinGate(const DopplerColumns& columns,
                          const DopplerGate& gate,
                          bool with_rest,
                          DopplerSums* sums,
                          unsigned char* inliers) {
  if (with_rest) {
    SumWithin<true>(columns, gate, sums, inliers);
  } else {
    SumWithin<false>(columns, gate, sums, inliers);
  }
}

}  // namespace radive::RADIVE_KERNELS
