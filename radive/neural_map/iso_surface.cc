// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/iso_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace radive {
namespace {

// Corner i of a cube lies at its origin plus bits 0, 1, 2 of i along x, y, z. An edge is the pair
// of corners that it joins: its lower corner and its axis, 12 in all.
constexpr int kNumCorners = 8;

// Corners of the six faces, counter-clockwise seen from outside.
constexpr std::array<std::array<int, 4>, 6> kFaces = {{{0, 4, 6, 2},    // x low
                                                       {1, 3, 7, 5},    // x high
                                                       {0, 1, 5, 4},    // y low
                                                       {2, 6, 7, 3},    // y high
                                                       {0, 2, 3, 1},    // z low
                                                       {4, 5, 7, 6}}};  // z high

// 3 * lower corner + axis of the edge between two neighbouring corners.
constexpr int EdgeOf(int a, int b) {
  const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
  return 3 * (a & b) + axis;
}

using EdgeLoops = std::vector<std::vector<int>>;

// The polygons that part the negative corners (the bits of `signs`) from the others, as loops of
// edges. On each face, walked around, a line joins the edge where a run of negative corners ends
// with the edge where it began. An edge ends a run on one of its two faces and begins one on the
// other, so the lines close to loops.
EdgeLoops LoopsOf(int signs) {
  std::array<int, 3 * kNumCorners> next;
  next.fill(-1);
  const auto is_negative = [signs](int corner) { return (signs >> corner & 1) != 0; };
  for (const std::array<int, 4>& face : kFaces) {
    for (std::size_t i = 0; i < 4; ++i) {
      const int before = face[i], first = face[(i + 1) % 4];
      if (is_negative(before) || !is_negative(first)) continue;
      std::size_t last = (i + 1) % 4;
      while (is_negative(face[(last + 1) % 4])) last = (last + 1) % 4;
      const int end = EdgeOf(face[last], face[(last + 1) % 4]);
      next[static_cast<std::size_t>(EdgeOf(before, first))] = end;
    }
  }
  EdgeLoops loops;
  for (int start = 0; start < static_cast<int>(next.size()); ++start) {
    std::vector<int> loop;
    for (int edge = start; next[static_cast<std::size_t>(edge)] >= 0;) {
      loop.push_back(edge);
      int& successor = next[static_cast<std::size_t>(edge)];
      edge = successor;
      successor = -1;
    }
    if (!loop.empty()) loops.push_back(loop);
  }
  return loops;
}

const std::array<EdgeLoops, 256>& LoopTable() {
  static const std::array<EdgeLoops, 256> table = [] {
    std::array<EdgeLoops, 256> loops;
    for (int signs = 0; signs < 256; ++signs) {
      loops[static_cast<std::size_t>(signs)] = LoopsOf(signs);
    }
    return loops;
  }();
  return table;
}

Eigen::Vector3i CornerOffset(int corner) { return {corner & 1, corner >> 1 & 1, corner >> 2 & 1}; }

class Mesher {
 public:
  Mesher(const SdfGrid& grid, double min_support) : grid_(grid), min_support_(min_support) {}

  void AddCube(const Eigen::Vector3i& origin) {
    std::array<const SdfGrid::Sample*, kNumCorners> samples;
    int signs = 0;
    for (int corner = 0; corner < kNumCorners; ++corner) {
      const SdfGrid::Sample* sample = grid_.At(origin + CornerOffset(corner));
      if (sample == nullptr || !(sample->support >= min_support_)) return;
      samples[static_cast<std::size_t>(corner)] = sample;
      if (sample->sdf < 0.0F) signs |= 1 << corner;
    }
    for (const std::vector<int>& loop : LoopTable()[static_cast<std::size_t>(signs)]) {
      std::vector<int> polygon;
      for (const int edge : loop) polygon.push_back(VertexOn(origin, edge, samples));
      for (std::size_t i = 2; i < polygon.size(); ++i) {
        mesh_.triangles.emplace_back(polygon[0], polygon[i - 1], polygon[i]);
      }
    }
  }

  TriangleMesh Take() { return std::move(mesh_); }

 private:
  // The mesh vertex on an edge of a cube; cubes that share the edge share it.
  int VertexOn(const Eigen::Vector3i& origin,
               int edge,
               const std::array<const SdfGrid::Sample*, kNumCorners>& samples) {
    const int low = edge / 3, axis = edge % 3;
    const Eigen::Vector3i base = origin + CornerOffset(low);
    const std::uint64_t key =
        CellKey(std::int64_t{base.x()}, std::int64_t{base.y()}, std::int64_t{base.z()});
    auto& indices = vertices_[static_cast<std::size_t>(axis)];
    const auto [entry, is_new] = indices.insert({key, static_cast<int>(mesh_.vertices.size())});
    if (!is_new) return entry->second;
    const SdfGrid::Sample& a = *samples[static_cast<std::size_t>(low)];
    const SdfGrid::Sample& b = *samples[static_cast<std::size_t>(low | 1 << axis)];
    // One is negative, the other is not, so they differ.
    const double share = static_cast<double>(a.sdf) / (static_cast<double>(a.sdf) - b.sdf);
    Eigen::Vector3d position = grid_.Position(base);
    position[axis] += share * grid_.spacing();
    mesh_.vertices.push_back(position);
    mesh_.support.push_back(std::min(a.support, b.support));
    return entry->second;
  }

  const SdfGrid& grid_;
  const double min_support_;
  TriangleMesh mesh_;
  // By the lower end of the edge, for each axis.
  std::array<tsl::robin_map<std::uint64_t, int, CellKeyHash>, 3> vertices_;
};

}  // namespace

TriangleMesh IsoSurface(const SdfGrid& grid, double min_support) {
  Mesher mesher(grid, min_support);
  for (const Eigen::Vector3i& vertex : grid.Vertices()) mesher.AddCube(vertex);
  return mesher.Take();
}

}  // namespace radive
