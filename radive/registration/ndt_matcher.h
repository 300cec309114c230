// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "radive/geometry/gaussian3.h"
#include "radive/ndt/distance_bounded_pairs.h"
#include "radive/registration/registration_options.h"
#include "radive/registration/scan_matcher.h"

namespace radive {

// NDT with the pairs that `pair_options` choose; with registration.method full_ndt all pairs.
// `scan` and `search` must outlive it.
std::unique_ptr<ScanMatcher> MakeNdtMatcher(const std::vector<Gaussian3>& scan,
                                            const PairSearch& search,
                                            const Eigen::Vector3d& origin,
                                            const PairOptions& pair_options,
                                            const RegistrationOptions& options);

}  // namespace radive
