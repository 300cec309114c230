// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// Which neural points lie on a surface, and what registration makes of them.
struct SurfaceOptions {
  enum class Criterion {
    kSdf,      // |S| <= threshold
    kDensity,  // as many points, but those of the largest support: what does learning add?
  };
  Criterion criterion = Criterion::kSdf;

  // Whether S at a neural point is what its neighbours say, without itself. The printed weight
  // 1 / d^2 is infinite for the point itself (neural_map.softening keeps it finite): then it alone
  // decides.
  bool leave_out_self = false;

  double threshold = 0.5;    // tau_s: |S| at most this [m]
  double min_support = 0.7;  // NeuralPoints::Support() at least this [-]

  // New points are kept for so many keyframes without these two: around a corner they are all that
  // there is to see, and have had no chance of support.
  int trial_keyframes = 8;

  // Share of the way to the surface that a point is moved, x - gain S n [-].
  double projection = 1.0;

  // Instead of being cut, points weigh exp(-S^2 / (2 threshold^2)) a / (a + min_support), a their
  // support.
  bool soft = false;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("surface", *this, error); }
};

}  // namespace radive
