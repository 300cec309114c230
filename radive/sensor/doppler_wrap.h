// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace radive {

// A difference of range rates [m/s] that is known but for multiples of `span` (SensorOptions::
// doppler_span): the one nearest to zero, in [-span/2, span/2]. As it is where the span is 0.
inline double WrapDoppler(double difference, double span) {
  return span > 0.0 ? difference - span * std::round(difference / span) : difference;
}

}  // namespace radive
