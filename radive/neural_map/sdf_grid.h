// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <tsl/robin_map.h>

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "radive/util/cell_key.h"

namespace radive {

// A signed distance field at the vertices of a regular grid, stored where something is known.
// Memory grows with the surface that was seen, some 30 bytes a vertex.
class SdfGrid {
 public:
  struct Sample {
    float sdf = 0.0F;      // positive on the side that the sensor saw [m]
    float support = 0.0F;  // see SdfValue [-]
  };

  // Vertices lie at multiples of `spacing` [m], > 0.
  explicit SdfGrid(double spacing) : spacing_(spacing) {}

  // Over an earlier sample of the same vertex.
  void Set(const Eigen::Vector3i& vertex, const Sample& sample) { samples_[Key(vertex)] = sample; }

  void Erase(const Eigen::Vector3i& vertex) { samples_.erase(Key(vertex)); }

  // nullptr where nothing is known. Valid until the next change.
  const Sample* At(const Eigen::Vector3i& vertex) const {
    const auto found = samples_.find(Key(vertex));
    return found == samples_.end() ? nullptr : &found->second;
  }

  Eigen::Vector3d Position(const Eigen::Vector3i& vertex) const {
    return spacing_ * vertex.cast<double>();
  }

  // All vertices, ascending by z, then y, then x.
  std::vector<Eigen::Vector3i> Vertices() const;

  double spacing() const { return spacing_; }
  std::size_t size() const { return samples_.size(); }

 private:
  static std::uint64_t Key(const Eigen::Vector3i& vertex) {
    return CellKey(std::int64_t{vertex.x()}, std::int64_t{vertex.y()}, std::int64_t{vertex.z()});
  }

  double spacing_;
  tsl::robin_map<std::uint64_t, Sample, CellKeyHash> samples_;
};

}  // namespace radive
