// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "radive/kernels/kernels.h"

namespace radive::testing {

// Has the library use these kernels as long as it lives.
class WithKernels {
 public:
  explicit WithKernels(const Kernels& kernels) : before_(ActiveKernels()) {
    SetActiveKernels(kernels);
  }
  ~WithKernels() { SetActiveKernels(before_); }
  WithKernels(const WithKernels&) = delete;
  WithKernels& operator=(const WithKernels&) = delete;

 private:
  const Kernels& before_;
};

}  // namespace radive::testing
