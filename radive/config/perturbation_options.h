// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// What a study changes of its input at random, to see how much a result depends on single returns,
// see docs/studies.md and ThinnedSource.
struct PerturbationOptions {
  double drop = 0.0;  // share of the returns that is left out [-]
  int seed = 0;       // of the choice

  std::vector<OptionField> Fields() {
    return {
        OptionField{"drop",
                    &drop,
                    "-",
                    "Share of the returns that is left out at random, to see what depends on "
                    "single returns; set by studies (perturb)."}
            .AtLeast(0.0)
            .AtMost(0.99),
        OptionField{"seed", &seed, "-", "Seed of that choice."}.AtLeast(0),
    };
  }

  bool IsValid(std::string* error) const { return CheckOptions("perturbation", *this, error); }
};

}  // namespace radive
