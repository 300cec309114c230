// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/map_files.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "radive/io/bytes/byte_order.h"

namespace radive {
namespace {

// The header for vertices with float32 `properties`, and for triangles if there are any.
std::string PlyHeader(std::size_t num_vertices,
                      const std::vector<std::string>& properties,
                      std::size_t num_triangles = 0) {
  std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment map of radive_odometry, world frame, metres\n"
      "element vertex " +
      std::to_string(num_vertices) + "\n";
  for (const std::string& property : properties) header += "property float " + property + "\n";
  if (num_triangles > 0) {
    header += "element face " + std::to_string(num_triangles) +
              "\nproperty list uchar int vertex_indices\n";
  }
  return header + "end_header\n";
}

void AppendFloats(const Eigen::Vector3d& values, std::string* bytes) {
  for (int axis = 0; axis < 3; ++axis) AppendLittleEndian(static_cast<float>(values[axis]), bytes);
}

std::vector<SurfacePoint> InWorld(const Rigid3& T_world_map, std::vector<SurfacePoint> points) {
  for (SurfacePoint& point : points) {
    point.position = T_world_map * point.position;
    point.normal = T_world_map.rotation * point.normal;
  }
  return points;
}

}  // namespace

std::string PointsPly(const std::vector<Eigen::Vector3d>& points) {
  std::string bytes = PlyHeader(points.size(), {"x", "y", "z"});
  bytes.reserve(bytes.size() + 12 * points.size());
  for (const Eigen::Vector3d& point : points) AppendFloats(point, &bytes);
  return bytes;
}

std::string SurfacePointsPly(const std::vector<SurfacePoint>& points) {
  std::string bytes =
      PlyHeader(points.size(), {"x", "y", "z", "nx", "ny", "nz", "sdf", "certainty"});
  for (const SurfacePoint& point : points) {
    AppendFloats(point.position, &bytes);
    AppendFloats(point.normal, &bytes);
    AppendLittleEndian(static_cast<float>(point.sdf), &bytes);
    AppendLittleEndian(static_cast<float>(point.support), &bytes);
  }
  return bytes;
}

std::string MeshPly(const std::vector<TriangleMesh>& meshes) {
  std::size_t num_vertices = 0, num_triangles = 0;
  for (const TriangleMesh& mesh : meshes) {
    num_vertices += mesh.vertices.size();
    num_triangles += mesh.triangles.size();
  }
  std::string bytes = PlyHeader(num_vertices, {"x", "y", "z", "certainty"}, num_triangles);
  for (const TriangleMesh& mesh : meshes) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      AppendFloats(mesh.vertices[i], &bytes);
      AppendLittleEndian(static_cast<float>(mesh.support[i]), &bytes);
    }
  }
  std::uint32_t first = 0;
  for (const TriangleMesh& mesh : meshes) {
    for (const Eigen::Vector3i& triangle : mesh.triangles) {
      bytes += '\3';
      for (int corner = 0; corner < 3; ++corner) {
        AppendLittleEndian(first + static_cast<std::uint32_t>(triangle[corner]), &bytes);
      }
    }
    first += static_cast<std::uint32_t>(mesh.vertices.size());
  }
  return bytes;
}

std::string SlicePly(const std::vector<PlacedGrid>& grids, double z, double min_support) {
  std::string rows;
  std::size_t count = 0;
  for (const auto& [T_world_map, grid] : grids) {
    const int layer = static_cast<int>(std::lround(z / grid->spacing()));
    for (const Eigen::Vector3i& vertex : grid->Vertices()) {
      if (vertex.z() != layer) continue;
      const SdfGrid::Sample& sample = *grid->At(vertex);
      if (!(sample.support >= min_support)) continue;
      AppendFloats(T_world_map * grid->Position(vertex), &rows);
      AppendLittleEndian(static_cast<float>(sample.sdf), &rows);
      AppendLittleEndian(static_cast<float>(sample.support), &rows);
      ++count;
    }
  }
  return PlyHeader(count, {"x", "y", "z", "sdf", "certainty"}) + rows;
}

std::vector<MapFile> MakeMapFiles(const OutputOptions& output,
                                  const SurfaceOptions& surface,
                                  const std::vector<Eigen::Vector3d>& points,
                                  const std::vector<RadarSurface>& surfaces) {
  MapFile map{"map.ply", {}}, neural_points{"neural_points.ply", {}};
  MapFile mesh{"mesh.ply", {}}, slice{"sdf_slice.ply", {}};
  if (output.map == OutputOptions::Map::kPoints) map.bytes = PointsPly(points);
  if (output.NeedsSurface()) {
    std::vector<SurfacePoint> all, selected;
    SurfaceOptions settled = surface;
    // Registration can do with doubtful points that weigh little, and cannot wait for a second
    // look.
    settled.soft = false;
    settled.trial_keyframes = 0;
    for (const auto& [T_world_map, record] : surfaces) {
      const std::vector<SurfacePoint> points_of_radar = InWorld(T_world_map, record.points());
      all.insert(all.end(), points_of_radar.begin(), points_of_radar.end());
      const std::vector<SurfacePoint> extracted = SelectSurface(points_of_radar, settled);
      selected.insert(selected.end(), extracted.begin(), extracted.end());
    }
    map.bytes = SurfacePointsPly(selected);
    neural_points.bytes = SurfacePointsPly(all);
  }
  if (output.map == OutputOptions::Map::kMesh) {
    std::vector<TriangleMesh> meshes;
    std::vector<PlacedGrid> grids;
    for (const auto& [T_world_map, record] : surfaces) {
      if (!record.grid()) continue;
      grids.push_back({T_world_map, &*record.grid()});
      meshes.push_back(IsoSurface(*record.grid(), surface.min_support));
      for (Eigen::Vector3d& vertex : meshes.back().vertices) vertex = T_world_map * vertex;
    }
    mesh.bytes = MeshPly(meshes);
    slice.bytes = SlicePly(grids, output.slice_height, surface.min_support);
  }
  return {map, neural_points, mesh, slice};
}

}  // namespace radive
