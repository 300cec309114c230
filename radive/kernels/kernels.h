// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/kernels/kernel_table.h"

namespace radive {

// Each kernel is written once, four numbers at a time, and compiled twice: for any processor, and
// for those with AVX2 and FMA. The two differ by rounding.

// Those that this processor can run, the fastest last.
std::vector<const Kernels*> AvailableKernels();

// What the library uses: the fastest, or what SetActiveKernels() has chosen.
const Kernels& ActiveKernels();

// One of AvailableKernels(): for tests that compare them. Not while others compute.
void SetActiveKernels(const Kernels& kernels);

}  // namespace radive
