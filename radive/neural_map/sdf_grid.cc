// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/sdf_grid.h"

#include <algorithm>
#include <tuple>

namespace radive {

std::vector<Eigen::Vector3i> SdfGrid::Vertices() const {
  std::vector<Eigen::Vector3i> vertices;
  vertices.reserve(samples_.size());
  for (const auto& entry : samples_) vertices.push_back(CellOfKey(entry.first));
  std::sort(
      vertices.begin(), vertices.end(), [](const Eigen::Vector3i& a, const Eigen::Vector3i& b) {
        return std::make_tuple(a.z(), a.y(), a.x()) < std::make_tuple(b.z(), b.y(), b.x());
      });
  return vertices;
}

}  // namespace radive
