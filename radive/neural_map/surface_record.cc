// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/surface_record.h"

#include <tsl/robin_set.h>

#include <algorithm>
#include <numeric>

#include "radive/neural_map/decoder_kernel.h"
#include "radive/neural_map/sdf_query.h"

namespace radive {
SurfaceRecord::SurfaceRecord(double grid_spacing, double min_support) : min_support_(min_support) {
  if (grid_spacing > 0.0) grid_.emplace(grid_spacing);
}

void SurfaceRecord::BeforeKeyframe(const NeuralPoints& map,
                                   const SdfDecoder& decoder,
                                   const Eigen::Vector3d& origin,
                                   int index) {
  // Late, for a place may be seen again; but while the neighbours, which are part of its field, are
  // in the map.
  const int unseen = (map.options().max_age + 1) / 2;
  std::vector<int> leaving;
  for (int k = 0; k < map.size(); ++k) {
    const NeuralPoint& point = map.point(k);
    const int age = index - 1 - point.last_update;
    const double distance = (point.position - origin).norm();
    if (age == unseen || (age < unseen && distance > map.options().max_distance)) {
      leaving.push_back(k);
    }
  }
  Update(map, decoder, leaving);
}

void SurfaceRecord::Finish(const NeuralPoints& map, const SdfDecoder& decoder) {
  std::vector<int> all(static_cast<std::size_t>(map.size()));
  std::iota(all.begin(), all.end(), 0);
  Update(map, decoder, all);
}

void SurfaceRecord::Update(const NeuralPoints& map,
                           const SdfDecoder& decoder,
                           const std::vector<int>& indices) {
  std::vector<int> supported;
  for (SurfacePoint point : EvaluatePoints(map, decoder, indices)) {
    if (point.support >= min_support_) supported.push_back(point.index);
    const std::uint64_t cell = map.point(point.index).cell;
    const auto [entry, is_new] =
        point_of_cell_.insert({cell, static_cast<std::int32_t>(points_.size())});
    point.index = entry->second;
    if (is_new) {
      points_.push_back(point);
    } else {
      points_[static_cast<std::size_t>(point.index)] = point;
    }
  }
  if (grid_) UpdateGrid(map, decoder, supported);
}

// The field is taken down in the cell of each point and one grid step around it, for the surface
// may lie on the border of the cell.
void SurfaceRecord::UpdateGrid(const NeuralPoints& map,
                               const SdfDecoder& decoder,
                               const std::vector<int>& indices) {
  const double resolution = map.options().resolution;
  const double spacing = grid_->spacing();
  tsl::robin_set<std::uint64_t, CellKeyHash> done;
  std::vector<NearPoint> near;
  WithDecoderKernel(decoder, resolution, [&](const auto& kernel) {
    for (const int k : indices) {
      const Eigen::Array3d low = (map.point(k).position.array() / resolution).floor() * resolution;
      const Eigen::Array3i first = (low / spacing).floor().cast<int>() - 1;
      const Eigen::Array3i last = ((low + resolution) / spacing).ceil().cast<int>() + 1;
      for (int z = first.z(); z <= last.z(); ++z) {
        for (int y = first.y(); y <= last.y(); ++y) {
          for (int x = first.x(); x <= last.x(); ++x) {
            if (!done.insert(CellKey(std::int64_t{x}, std::int64_t{y}, std::int64_t{z})).second) {
              continue;
            }
            const Eigen::Vector3i vertex(x, y, z);
            const Eigen::Vector3d position = grid_->Position(vertex);
            map.FindNear(position, &near);
            const SdfValue field = QuerySdf(map, kernel, position, near);
            const double support = map.Support(near);
            if (field.num_neighbors > 0 && support >= min_support_) {
              grid_->Set(vertex, {static_cast<float>(field.value), static_cast<float>(support)});
            } else {
              grid_->Erase(vertex);
            }
          }
        }
      }
    }
  });
}

}  // namespace radive
