// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/surface_record.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radive/neural_map/iso_surface.h"
#include "radive/training/sdf_mapper.h"
#include "tests/neural_map/made_map.h"

// The map of a drive past walls whose place is known.

namespace radive {
namespace {

using testing::ReturnsAt;

// A wall at y = 5 m, seen from y = 0, between x and x + 6 m.
MapKeyframe WallFrom(double x) {
  std::vector<Eigen::Vector3d> points;
  for (double along = 0.0; along <= 6.0; along += 0.1) {
    for (double z = -1.0; z <= 1.0; z += 0.1) points.emplace_back(x + along, 5.0, z);
  }
  return {{x + 3.0, 0.0, 0.0}, ReturnsAt(points)};
}

SdfTrainingOptions WellTrained() {
  SdfTrainingOptions training;
  training.label_points = 8;
  training.samples_per_point = 32;
  training.sample_extent = 0.4;
  training.label_sigma = 0.02;
  training.solver.max_iterations = 20;
  return training;
}

class Drive {
 public:
  explicit Drive(const NeuralMapOptions& options, double min_support = 1.0)
      : mapper_(options, WellTrained()), record_(0.25, min_support) {}

  void Add(const MapKeyframe& keyframe) {
    record_.BeforeKeyframe(mapper_.map(), mapper_.decoder(), keyframe.origin, num_keyframes_++);
    mapper_.AddKeyframe(keyframe);
  }

  // Of the drive up to here.
  const SurfaceRecord& Record() {
    record_.Finish(mapper_.map(), mapper_.decoder());
    return record_;
  }
  const NeuralPoints& map() const { return mapper_.map(); }

 private:
  SdfMapper mapper_;
  int num_keyframes_ = 0;
  SurfaceRecord record_;
};

TEST(SurfaceRecord, TheMeshOfAWallLiesOnTheWall) {
  Drive drive((NeuralMapOptions()));
  for (int repeat = 0; repeat < 2; ++repeat) drive.Add(WallFrom(0.0));
  const TriangleMesh mesh = IsoSurface(*drive.Record().grid(), 1.0);
  double area = 0.0, sum = 0.0;
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    const auto corner = [&](int i) { return mesh.vertices[static_cast<std::size_t>(triangle[i])]; };
    const Eigen::Vector3d vector = 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0));
    area += -vector.y();  // positive towards the radar
  }
  for (const Eigen::Vector3d& vertex : mesh.vertices) sum += std::pow(vertex.y() - 5.0, 2);
  const double rms = std::sqrt(sum / static_cast<double>(mesh.vertices.size()));
  std::cout << "rms " << rms << " m, area " << area << " m^2\n";
  EXPECT_LT(rms, 0.03);
  // 6 m x 2 m, and up to a cell around it.
  EXPECT_GT(area, 11.0);
  EXPECT_LT(area, 7.5 * 3.5);
}

TEST(SurfaceRecord, KeepsWhatTheMapForgetsAndCountsNothingTwice) {
  NeuralMapOptions options;
  options.max_distance = 10.0;
  Drive drive(options);
  drive.Add(WallFrom(0.0));
  const std::size_t num_first = drive.Record().points().size();
  const std::size_t num_vertices = drive.Record().grid()->size();
  EXPECT_EQ(num_first, static_cast<std::size_t>(drive.map().size()));
  drive.Add(WallFrom(100.0));
  const std::size_t num_both = drive.Record().points().size();
  EXPECT_EQ(drive.map().size(), static_cast<int>(num_both - num_first)) << "the map has forgotten";
  EXPECT_GT(drive.Record().grid()->size(), 1.5 * static_cast<double>(num_vertices));
  for (int lap = 0; lap < 3; ++lap) {
    drive.Add(WallFrom(0.0));
    drive.Add(WallFrom(100.0));
  }
  EXPECT_EQ(drive.Record().points().size(), num_both);
  for (std::size_t i = 0; i < num_both; ++i) {
    EXPECT_EQ(drive.Record().points()[i].index, static_cast<int>(i));
  }
}

// Without a call of Finish(): each place once the drive has left it behind.
TEST(SurfaceRecord, TakesDownWhatTheLastKeyframesDidNotSee) {
  NeuralMapOptions options;
  options.max_age = 4;
  SdfMapper mapper(options, WellTrained());
  SurfaceRecord record(0.0, 1.0);
  std::vector<std::size_t> sizes;
  for (int k = 0; k < 5; ++k) {
    const MapKeyframe keyframe = WallFrom(20.0 * k);
    record.BeforeKeyframe(mapper.map(), mapper.decoder(), keyframe.origin, k);
    sizes.push_back(record.points().size());
    mapper.AddKeyframe(keyframe);
  }
  EXPECT_EQ(sizes[2], 0u);
  EXPECT_GT(sizes[3], 0u) << "keyframes 1 and 2 did not see what keyframe 0 saw";
  EXPECT_EQ(sizes[4], 2 * sizes[3]);
}

TEST(SurfaceRecord, TheLastWordCountsAndExtractionIsThatOfTheMap) {
  Drive drive(NeuralMapOptions(), 1.5);
  for (int repeat = 0; repeat < 3; ++repeat) drive.Add(WallFrom(0.0));
  MapKeyframe ghost = WallFrom(0.0);
  ghost.returns = ReturnsAt({{3.0, 9.0, 0.0}});
  drive.Add(ghost);
  SurfaceOptions surface;
  surface.min_support = 2.0;
  surface.trial_keyframes = 0;
  surface.projection = 0.0;
  const std::vector<SurfacePoint> selected = SelectSurface(drive.Record().points(), surface);
  EXPECT_GT(selected.size(), 40u);
  for (const SurfacePoint& point : selected) {
    EXPECT_NEAR(point.position.y(), 5.0, 1e-9) << "a lone ghost is no surface";
    EXPECT_LE(std::abs(point.sdf), surface.threshold);
    EXPECT_GE(point.support, 2.0);
    EXPECT_LT(point.normal.y(), -0.9) << "towards the radar";
  }
  EXPECT_EQ(drive.Record().points().back().position, Eigen::Vector3d(3.0, 9.0, 0.0));
  for (const Eigen::Vector3i& vertex : drive.Record().grid()->Vertices()) {
    EXPECT_LT(drive.Record().grid()->Position(vertex).y(), 8.0) << "nor part of the field";
    EXPECT_GE(drive.Record().grid()->At(vertex)->support, 1.5F);
  }
}

TEST(SurfaceRecord, NoGridUnlessAskedFor) {
  EXPECT_FALSE(SurfaceRecord(0.0, 1.0).grid().has_value());
  EXPECT_EQ(SurfaceRecord(0.5, 1.0).grid()->spacing(), 0.5);
}

}  // namespace
}  // namespace radive
