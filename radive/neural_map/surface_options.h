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

  double threshold = 0.1;    // tau_s: |S| at most this [m]
  double min_support = 2.0;  // certainty of the point and its neighbours at least this [-]

  // Share of the way to the surface that a point is moved, x - gain S n [-].
  double projection = 0.0;

  // Instead of a hard threshold: weights fall as exp(-S^2 / (2 threshold^2)), and nothing is left
  // out for its distance.
  bool soft = false;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("surface", *this, error); }
};

}  // namespace radive
