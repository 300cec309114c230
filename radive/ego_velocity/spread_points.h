// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace radive {

// Points farther from the radar are left out, angles being worth little there [m].
inline constexpr double kFarthestPoint = 80.0;

// Indices of points that are spread over a scan: of those in each square of half a metre the first,
// `max_count` squares at most. Which squares those are depends on their places alone, so that two
// scans keep the same ones.
std::vector<std::size_t> SpreadOut(const std::vector<Eigen::Vector2d>& points,
                                   std::size_t max_count);

}  // namespace radive
