// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tsl/robin_map.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "radive/neural_map/sdf_grid.h"
#include "radive/neural_map/surface_extractor.h"

namespace radive {

// What a neural map has said of all places so far, also of those that it has forgotten since: the
// map of a drive. The last word on a place counts, so memory grows with the area and not with the
// time.
class SurfaceRecord {
 public:
  // With `grid_spacing` > 0 [m] the field is kept at the vertices of a grid, too: where its support
  // is at least `min_support`, in the cells of points of which the same holds.
  SurfaceRecord(double grid_spacing, double min_support);

  // To be called before keyframe `index`, measured from `origin` [m], goes into `map`: takes down
  // what has not been seen for half of the age at which the map forgets, and what it is about to
  // forget for its distance. Training changes only what keyframes see.
  void BeforeKeyframe(const NeuralPoints& map,
                      const SdfDecoder& decoder,
                      const Eigen::Vector3d& origin,
                      int index);

  // To be called at the end: takes down all that is in `map`.
  void Finish(const NeuralPoints& map, const SdfDecoder& decoder);

  // One a cell that ever held a neural point, in the order in which they were first seen; `index`
  // counts them.
  const std::vector<SurfacePoint>& points() const { return points_; }

  // Empty without a grid spacing.
  const std::optional<SdfGrid>& grid() const { return grid_; }

 private:
  // Takes down the field at the neural points `indices`, and in the cells about them.
  void Update(const NeuralPoints& map, const SdfDecoder& decoder, const std::vector<int>& indices);
  void UpdateGrid(const NeuralPoints& map,
                  const SdfDecoder& decoder,
                  const std::vector<int>& indices);

  double min_support_;
  std::vector<SurfacePoint> points_;
  tsl::robin_map<std::uint64_t, std::int32_t, CellKeyHash> point_of_cell_;
  std::optional<SdfGrid> grid_;
};

}  // namespace radive
