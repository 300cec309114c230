// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/iso_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "radive/util/angle_units.h"
#include "radive/util/random.h"

namespace radive {
namespace {

using Field = std::function<double(const Eigen::Vector3d&)>;

// The field at all vertices with coordinates -n .. n.
SdfGrid GridOf(const Field& field, double spacing, int n) {
  SdfGrid grid(spacing);
  for (int x = -n; x <= n; ++x) {
    for (int y = -n; y <= n; ++y) {
      for (int z = -n; z <= n; ++z) {
        const Eigen::Vector3i vertex(x, y, z);
        grid.Set(vertex, {static_cast<float>(field(grid.Position(vertex))), 1.0F});
      }
    }
  }
  return grid;
}

Eigen::Vector3d AreaVector(const TriangleMesh& mesh, const Eigen::Vector3i& triangle) {
  const auto corner = [&](int i) { return mesh.vertices[static_cast<std::size_t>(triangle[i])]; };
  return 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0));
}

double Area(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const Eigen::Vector3i& triangle : mesh.triangles) area += AreaVector(mesh, triangle).norm();
  return area;
}

// How often each edge is walked from its first to its second vertex.
std::map<std::pair<int, int>, int> DirectedEdges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) ++edges[{triangle[i], triangle[(i + 1) % 3]}];
  }
  return edges;
}

// Every edge is walked once in each direction: no cracks, one orientation.
void ExpectClosed(const TriangleMesh& mesh) {
  const auto edges = DirectedEdges(mesh);
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
}

TEST(IsoSurface, APlaneIsExactAndFacesThePositiveSide) {
  const Eigen::Vector3d normal = Eigen::Vector3d(0.3, -0.2, 1.0).normalized();
  const double offset = 0.13;
  const TriangleMesh mesh =
      IsoSurface(GridOf([&](const auto& p) { return normal.dot(p) - offset; }, 0.5, 8), 1.0);
  ASSERT_FALSE(mesh.triangles.empty());
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    EXPECT_NEAR(normal.dot(vertex), offset, 1e-6);
  }
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const Eigen::Vector3d area = AreaVector(mesh, triangle);
    if (area.norm() > 1e-9) {
      EXPECT_GT(area.normalized().dot(normal), 0.999);
    }
  }
  // The plane covers the whole square of 8 m x 8 m seen from above.
  EXPECT_NEAR(Area(mesh), 64.0 / normal.z(), 1e-4);
}

TEST(IsoSurface, ASphereIsClosedWithItsAreaAndVolume) {
  const double radius = 1.5, spacing = 0.2;
  const TriangleMesh mesh =
      IsoSurface(GridOf([&](const auto& p) { return p.norm() - radius; }, spacing, 10), 1.0);
  ExpectClosed(mesh);
  const int num_edges = static_cast<int>(DirectedEdges(mesh).size()) / 2;
  const int num_vertices = static_cast<int>(mesh.vertices.size());
  EXPECT_EQ(num_vertices - num_edges + static_cast<int>(mesh.triangles.size()), 2);
  double volume = 0.0;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const Eigen::Vector3d corner = mesh.vertices[static_cast<std::size_t>(triangle[0])];
    volume += AreaVector(mesh, triangle).dot(corner) / 3.0;
  }
  EXPECT_NEAR(volume, 4.0 / 3.0 * kPi * std::pow(radius, 3), 0.02 * volume);
  EXPECT_NEAR(Area(mesh), 4.0 * kPi * radius * radius, 0.02 * Area(mesh));
  // A chord of length h leaves a circle of radius r by at most h^2 / (8 r).
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    EXPECT_NEAR(vertex.norm(), radius, spacing * spacing / (8.0 * radius) + 1e-6);
  }
}

TEST(IsoSurface, ABoxKeepsItsFaces) {
  const Eigen::Vector3d half(1.1, 0.7, 0.9);
  const auto box = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = p.cwiseAbs() - half;
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
  };
  const TriangleMesh mesh = IsoSurface(GridOf(box, 0.2, 8), 1.0);
  ExpectClosed(mesh);
  for (const Eigen::Vector3d& vertex : mesh.vertices) EXPECT_NEAR(box(vertex), 0.0, 0.05);
  Eigen::Vector3d largest = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : mesh.vertices) largest = largest.cwiseMax(vertex);
  EXPECT_LT((largest - half).norm(), 1e-6);
}

// Random signs run through all ambiguous cases, between cubes and within them.
TEST(IsoSurface, NoiseHasNoCracks) {
  constexpr int kSize = 6;
  Random random(3);
  const SdfGrid noise = GridOf([&](const auto&) { return random.Normal(); }, 1.0, kSize);
  SdfGrid grid(1.0);
  for (const Eigen::Vector3i& vertex : noise.Vertices()) {
    // Positive all around, so that the surface is closed.
    const bool is_border = vertex.cwiseAbs().maxCoeff() == kSize;
    grid.Set(vertex, is_border ? SdfGrid::Sample{1.0F, 1.0F} : *noise.At(vertex));
  }
  const TriangleMesh mesh = IsoSurface(grid, 1.0);
  EXPECT_GT(mesh.triangles.size(), 1000u);
  ExpectClosed(mesh);
}

TEST(IsoSurface, StopsWhereTheFieldIsUnknownOrPoorlySupported) {
  const auto plane = [](const Eigen::Vector3d& p) { return p.z() - 0.5; };
  SdfGrid grid = GridOf(plane, 1.0, 2);
  EXPECT_NEAR(Area(IsoSurface(grid, 1.0)), 16.0, 1e-9);
  // Every vertex of the layer below is part of up to four of the 16 cubes that the plane crosses.
  grid.Set({0, 0, 0}, {-0.5F, 0.99F});
  EXPECT_NEAR(Area(IsoSurface(grid, 1.0)), 12.0, 1e-9);
  EXPECT_NEAR(Area(IsoSurface(grid, 0.9)), 16.0, 1e-9);
  grid.Set({2, 2, 0}, {-0.5F, std::nanf("")});
  EXPECT_NEAR(Area(IsoSurface(grid, 0.9)), 15.0, 1e-9);
  EXPECT_TRUE(IsoSurface(SdfGrid(1.0), 0.0).triangles.empty());
}

TEST(SdfGrid, VerticesAreSortedAndKeepTheirSigns) {
  SdfGrid grid(0.5);
  grid.Set({3, -4, 1}, {1.0F, 1.0F});
  grid.Set({-1000000, 2, -7}, {2.0F, 1.0F});
  grid.Set({-5, -4, 1}, {3.0F, 1.0F});
  grid.Set({-5, -4, 1}, {4.0F, 1.0F});
  const std::vector<Eigen::Vector3i> expected = {{-1000000, 2, -7}, {-5, -4, 1}, {3, -4, 1}};
  EXPECT_EQ(grid.Vertices(), expected);
  EXPECT_EQ(grid.At({-5, -4, 1})->sdf, 4.0F);
  EXPECT_EQ(grid.At({5, -4, 1}), nullptr);
  EXPECT_EQ(grid.Position({3, -4, 1}), Eigen::Vector3d(1.5, -2.0, 0.5));
}

}  // namespace
}  // namespace radive
