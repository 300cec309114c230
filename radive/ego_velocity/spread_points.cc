// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ego_velocity/spread_points.h"

#include <algorithm>
#include <bitset>
#include <cstdint>

#include "radive/util/random.h"

namespace radive {
namespace {

constexpr double kSquare = 0.5;                                             // [m]
constexpr int kSquares = static_cast<int>(2.0 * kFarthestPoint / kSquare);  // along an axis

}  // namespace

// The squares that come first in an order that is drawn for each are kept.
std::vector<std::size_t> SpreadOut(const std::vector<Eigen::Vector2d>& points,
                                   std::size_t max_count) {
  struct Square {
    std::uint64_t order;
    std::size_t point;
  };
  std::vector<Square> squares;
  std::bitset<kSquares * kSquares> is_taken;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d& p = points[i];
    if (!(p.squaredNorm() < kFarthestPoint * kFarthestPoint)) continue;
    const auto column = static_cast<std::size_t>(p.x() / kSquare + 0.5 * kSquares);
    const auto row = static_cast<std::size_t>(p.y() / kSquare + 0.5 * kSquares);
    const std::size_t square = row * kSquares + column;
    if (is_taken[square]) continue;
    is_taken[square] = true;
    squares.push_back({Random(square).Bits(), i});
  }
  const auto is_before = [](const Square& a, const Square& b) { return a.order < b.order; };
  if (squares.size() > max_count) {
    const auto end = squares.begin() + static_cast<std::ptrdiff_t>(max_count);
    std::nth_element(squares.begin(), end, squares.end(), is_before);
    squares.erase(end, squares.end());
  }
  std::sort(squares.begin(), squares.end(), is_before);
  std::vector<std::size_t> indices;
  indices.reserve(squares.size());
  for (const Square& square : squares) indices.push_back(square.point);
  return indices;
}

}  // namespace radive
