// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Arithmetic on four numbers at a time, for the files that define RADIVE_KERNELS, the namespace of
// one instruction set.

#pragma once

#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "radive/kernels/ndt_packs.h"

namespace radive::RADIVE_KERNELS {

// GCC and clang turn operators on these into whatever the processor has.
using Pack = double __attribute__((vector_size(32)));
using Bits = long long __attribute__((vector_size(32)));  // also the result of comparisons: 0 or -1

inline Pack Load(const void* four) {
  Pack pack;
  __builtin_memcpy(&pack, four, sizeof(pack));
  return pack;
}

inline Pack All(double value) { return Pack{value, value, value, value}; }

// Zero where the mask is.
inline Pack Where(Bits mask, Pack pack) { return (Pack)((Bits)pack & mask); }

// One bit for each of the four.
inline int Which(Bits mask) {
#ifdef __AVX2__
  return _mm256_movemask_pd((__m256d)mask);
#else
  return static_cast<int>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
}

inline Pack Sqrt(Pack pack) {
#ifdef __AVX2__
  return (Pack)_mm256_sqrt_pd((__m256d)pack);
#else
  return Pack{__builtin_sqrt(pack[0]),
              __builtin_sqrt(pack[1]),
              __builtin_sqrt(pack[2]),
              __builtin_sqrt(pack[3])};
#endif
}

// To the nearest whole number, of less than 2^51 in size: adding 1.5 * 2^52 leaves no bits for a
// fraction.
inline Pack RoundSmall(Pack pack) {
  const Pack shift = All(6755399441055744.0);
  return (pack + shift) - shift;
}

inline double Sum(Pack pack) { return (pack[0] + pack[2]) + (pack[1] + pack[3]); }

// exp(x) for -700 < x < 700: with n = round(x / log 2) and r = x - n log 2, |r| <= 0.347, it is
// 2^n times the Taylor polynomial of exp(r) of degree 11, which leaves out less than 0.347^12 / 12!
// = 7e-15. Numbers beyond give nonsense, but no trap.
inline Pack Exp(Pack x) {
  // As in RoundSmall(); the sum ends in the bits of the whole number n.
  const Pack shift = All(6755399441055744.0);
  const Pack shifted = x * 1.4426950408889634 + shift;
  const Pack n = shifted - shift;
  // log 2 in two parts, the first of which has zeros at its end: n times it is exact.
  const Pack r = (x - n * 0x1.62e42feep-1) - n * 0x1.a39ef35793c76p-33;
  const Pack r2 = r * r;
  const Pack odd =
      1.0 + r2 * (1.0 / 6 + r2 * (1.0 / 120 +
                                  r2 * (1.0 / 5040 + r2 * (1.0 / 362880 + r2 * (1.0 / 39916800)))));
  const Pack even =
      1.0 + r2 * (1.0 / 2 +
                  r2 * (1.0 / 24 + r2 * (1.0 / 720 + r2 * (1.0 / 40320 + r2 * (1.0 / 3628800)))));
  const Pack power = even + r * odd;
  return (Pack)((Bits)power + ((Bits)shifted << 52));  // n added to the exponent
}

}  // namespace radive::RADIVE_KERNELS
