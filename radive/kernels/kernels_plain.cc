// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#define RADIVE_KERNELS plain_kernels

#include "radive/kernels/displacement_votes_kernel.h"
#include "radive/kernels/doppler_kernel.h"
#include "radive/kernels/kernel_table.h"
#include "radive/kernels/ndt_pairs_kernel.h"
#include "radive/kernels/near_gaussians_kernel.h"

namespace radive {

const Kernels* PlainKernels() {
  static constexpr Kernels kKernels = {"plain",
                                       plain_kernels::SumNdtPairs,
                                       plain_kernels::FindNear,
                                       plain_kernels::CountWithinGate,
                                       plain_kernels::SumWithinGate,
                                       plain_kernels::AddVotes,
                                       plain_kernels::RaiseToBoxes};
  return &kKernels;
}

}  // namespace radive
