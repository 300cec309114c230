// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#define RADIVE_KERNELS plain_kernels

#include "radive/kernels/kernel_table.h"
#include "radive/kernels/ndt_pairs_kernel.h"

namespace radive {

const Kernels* PlainKernels() {
  static constexpr Kernels kKernels = {"plain", plain_kernels::SumNdtPairs};
  return &kKernels;
}

}  // namespace radive
