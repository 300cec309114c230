// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "radive/kernels/ndt_packs.h"

namespace radive {

// The loops that most of the time goes into, on plain arrays, see kernels.h.
struct Kernels {
  const char* name;

  // At the pose with the rotation R (rows one after the other) and the translation t.
  void (*sum_ndt_pairs)(const NdtPacks& packs, const double* R, const double* t, NdtSums* sums);
};

const Kernels* PlainKernels();
const Kernels* Avx2Kernels();  // nullptr where this processor cannot run them

}  // namespace radive
