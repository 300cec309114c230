// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace radive {

// How the Gaussian of a pair is scaled in the NDT cost.
enum class NdtNormalisation {
  kPaper,  // a probability density: divided by sqrt((2 pi)^3 |Sigma|), as printed in the paper
  kUnit,   // peak height 1: all pairs count alike, however wide they are
};

// How the derivatives inside the condensed block are formed.
enum class NdtDerivatives {
  kAnalytic,  // closed form; the 6x6 matrix holds Sigma fixed
  kAutodiff,  // Jets through NdtPairFactor: the reference, three to four times slower
};

}  // namespace radive
