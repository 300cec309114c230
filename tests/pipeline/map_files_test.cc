// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/pipeline/map_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "radive/io/bytes/byte_order.h"
#include "radive/io/points/ply.h"

namespace radive {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string Body(const std::string& bytes) { return bytes.substr(bytes.find("end_header\n") + 11); }

float FloatAt(const std::string& body, std::size_t index) {
  return NumberAt<float>(body.data() + 4 * index);
}

TEST(MapFiles, PointsAreLittleEndianFloats) {
  const std::string bytes = PointsPly({{1.0, -2.0, 0.5}});
  EXPECT_THAT(bytes, HasSubstr("element vertex 1\nproperty float x\n"));
  // 1.0f = 0x3F800000, -2.0f = 0xC0000000, 0.5f = 0x3F000000, low byte first.
  EXPECT_EQ(Body(bytes), std::string("\0\0\x80\x3F\0\0\0\xC0\0\0\0\x3F", 12));
}

SurfacePoint PointAt(double x, double sdf, double support) {
  SurfacePoint point;
  point.position = {x, 2.0, 3.0};
  point.normal = {0.0, -1.0, 0.0};
  point.sdf = sdf;
  point.support = support;
  return point;
}

TEST(MapFiles, SurfacePointsCarryNormalSdfAndCertainty) {
  const std::string bytes = SurfacePointsPly({PointAt(1.0, -0.25, 4.5)});
  PointTable table;
  std::vector<std::string> remarks;
  std::string error;
  ASSERT_TRUE(ParsePly(bytes, &table, &remarks, &error)) << error;
  EXPECT_TRUE(remarks.empty());
  const std::string body = Body(bytes);
  ASSERT_EQ(body.size(), 32u);
  const float expected[] = {1.0F, 2.0F, 3.0F, 0.0F, -1.0F, 0.0F, -0.25F, 4.5F};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(FloatAt(body, i), expected[i]) << i;
  EXPECT_THAT(bytes, HasSubstr("float nz\nproperty float sdf\nproperty float certainty\nend"));
}

TEST(MapFiles, TrianglesOfASecondMeshPointToItsOwnVertices) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.support = {1.0F, 2.0F, 3.0F};
  mesh.triangles = {{0, 1, 2}};
  const std::string bytes = MeshPly({mesh, mesh});
  EXPECT_THAT(bytes, HasSubstr("element vertex 6\n"));
  EXPECT_THAT(bytes, HasSubstr("element face 2\nproperty list uchar int vertex_indices\n"));
  const std::string body = Body(bytes);
  ASSERT_EQ(body.size(), 6u * 16u + 2u * 13u);
  EXPECT_EQ(body.substr(96, 13), std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13));
  EXPECT_EQ(body.substr(109, 13), std::string("\3\3\0\0\0\4\0\0\0\5\0\0\0", 13));
}

TEST(MapFiles, TheSliceIsTheNearestLayer) {
  SdfGrid grid(0.5);
  grid.Set({2, 0, 1}, {0.25F, 2.0F});
  grid.Set({4, 0, 1}, {0.75F, 1.0F});
  grid.Set({2, 0, 2}, {0.5F, 2.0F});
  const std::string body = Body(SlicePly({{Rigid3(), &grid}}, 0.6, 1.5));
  ASSERT_EQ(body.size(), 20u);
  const float expected[] = {1.0F, 0.0F, 0.5F, 0.25F, 2.0F};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(FloatAt(body, i), expected[i]) << i;
}

std::vector<std::string> NamesOf(OutputOptions::Map map) {
  OutputOptions output;
  output.map = map;
  std::vector<std::string> names;
  for (const MapFile& file : MakeMapFiles(output, SurfaceOptions(), {}, {})) {
    if (file.bytes) names.push_back(file.name);
  }
  return names;
}

TEST(MapFiles, EachKindHasItsFiles) {
  EXPECT_TRUE(NamesOf(OutputOptions::Map::kNone).empty());
  EXPECT_THAT(NamesOf(OutputOptions::Map::kPoints), ElementsAre("map.ply"));
  EXPECT_THAT(NamesOf(OutputOptions::Map::kSurface), ElementsAre("map.ply", "neural_points.ply"));
  EXPECT_THAT(NamesOf(OutputOptions::Map::kMesh),
              ElementsAre("map.ply", "neural_points.ply", "mesh.ply", "sdf_slice.ply"));
}

}  // namespace
}  // namespace radive
