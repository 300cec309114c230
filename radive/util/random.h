// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>

namespace radive {

// Seeded pseudo-random numbers with the same sequence on every platform and standard library
// (std::normal_distribution and friends are not portable). Generator: SplitMix64.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t Bits() {
    state_ += 0x9E3779B97F4A7C15ull;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }

  // Uniform in [0, 1).
  double Uniform() { return static_cast<double>(Bits() >> 11) * 0x1.0p-53; }

  // Uniform in [low, high).
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }

  // Uniform in {0, ..., count - 1}; count > 0. The bias of the modulo is below 1e-9 for counts
  // under 1e9.
  std::uint64_t Index(std::uint64_t count) { return Bits() % count; }

  // Normal with zero mean and unit standard deviation (Box-Muller).
  double Normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
    return radius * std::cos(6.283185307179586476925 * Uniform());
  }

 private:
  std::uint64_t state_;
};

}  // namespace radive
