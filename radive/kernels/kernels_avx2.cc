// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

// Compiled for processors with AVX2 and FMA where the compiler can (CMakeLists.txt), so that
// nothing else may be included here: an inline function of another header, compiled for such a
// processor, could be the copy that the linker keeps for all.

#define RADIVE_KERNELS avx2_kernels

#include "radive/kernels/displacement_votes_kernel.h"
#include "radive/kernels/doppler_kernel.h"
#include "radive/kernels/kernel_table.h"
#include "radive/kernels/ndt_pairs_kernel.h"
#include "radive/kernels/near_gaussians_kernel.h"

namespace radive {

#ifdef __AVX2__
const Kernels* Avx2Kernels() {
  static constexpr Kernels kKernels = {"avx2",
                                       avx2_kernels::SumNdtPairs,
                                       avx2_kernels::FindNear,
                                       avx2_kernels::CountWithinGate,
                                       avx2_kernels::SumWithinGate,
                                       avx2_kernels::AddVotes,
                                       avx2_kernels::RaiseToBoxes};
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? &kKernels : nullptr;
}
#else
const Kernels* Avx2Kernels() { return nullptr; }
#endif

}  // namespace radive
