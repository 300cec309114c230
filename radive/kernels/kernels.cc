// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/kernels/kernels.h"

#include <atomic>

namespace radive {
namespace {

std::atomic<const Kernels*>& Active() {
  static std::atomic<const Kernels*> active(AvailableKernels().back());
  return active;
}

}  // namespace

std::vector<const Kernels*> AvailableKernels() {
  std::vector<const Kernels*> available = {PlainKernels()};
  if (Avx2Kernels() != nullptr) available.push_back(Avx2Kernels());
  return available;
}

const Kernels& ActiveKernels() { return *Active().load(std::memory_order_relaxed); }

void SetActiveKernels(const Kernels& kernels) { Active().store(&kernels); }

}  // namespace radive
