// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/training/sdf_samples.h"

#include <algorithm>
#include <cmath>

#include "radive/geometry/rotation_between.h"
#include "radive/util/random.h"

namespace radive {
namespace {

std::uint64_t MixSeed(std::uint64_t seed, std::uint64_t index, std::uint64_t cell) {
  Random random(seed);
  const std::uint64_t a = random.Bits();
  Random second(a ^ (index * 0x9E3779B97F4A7C15ull));
  const std::uint64_t b = second.Bits();
  return b ^ cell;
}

}  // namespace

std::vector<SdfSample> DrawSamples(const NeuralPoints& map,
                                   const std::vector<int>& owners,
                                   const SdfLabels& labels,
                                   int index,
                                   const SdfTrainingOptions& options) {
  std::vector<SdfSample> samples;
  std::vector<NearPoint> near;
  samples.reserve(owners.size() * static_cast<std::size_t>(options.samples_per_point));
  for (const int owner : owners) {
    const NeuralPoint& point = map.point(owner);
    Random random(MixSeed(
        static_cast<std::uint64_t>(options.seed), static_cast<std::uint64_t>(index), point.cell));
    for (int i = 0; i < options.samples_per_point; ++i) {
      SdfSample sample;
      sample.owner = owner;
      for (int axis = 0; axis < 3; ++axis) {
        sample.position[axis] =
            point.position[axis] + random.Uniform(-options.sample_extent, options.sample_extent);
      }
      map.FindNear(sample.position, &near);
      sample.neighbors = map.Nearest(near);
      if (sample.neighbors.count == 0) continue;
      const std::optional<SdfLabel> label = labels.At(sample.position, near);
      if (!label || !(label->weight > 0.0) || !std::isfinite(label->distance)) continue;
      sample.label = *label;
      samples.push_back(sample);
    }
  }
  return samples;
}

std::vector<double> FirstFeature(const NeuralMapOptions& options,
                                 double offset,
                                 const Eigen::Vector3d& normal) {
  std::vector<double> feature(static_cast<std::size_t>(options.feature_dim), 0.0);
  feature[0] = std::clamp(offset / options.resolution, -2.0, 2.0);
  if (options.orientation == NeuralMapOptions::Orientation::kIdentity) {
    for (std::size_t i = 0; i < 3; ++i) feature[i + 1] = normal[static_cast<Eigen::Index>(i)];
  }
  return feature;
}

void InitialisePoints(NeuralPoints* map,
                      const std::vector<int>& seen,
                      const SdfLabels& labels,
                      int index) {
  std::vector<NearPoint> near;
  for (const int k : seen) {
    NeuralPoint& point = map->point(k);
    if (point.created != index) continue;
    map->FindNear(point.position, &near);
    const std::optional<LocalPlane> plane = labels.PlaneAt(point.position, near);
    if (!plane) continue;
    if (map->options().orientation == NeuralMapOptions::Orientation::kNormal) {
      point.orientation = RotationBetween(plane->normal, Eigen::Vector3d::UnitZ());
    }
    const std::vector<double> feature = FirstFeature(
        map->options(), plane->normal.dot(point.position - plane->point), plane->normal);
    std::copy(feature.begin(), feature.end(), map->feature(k));
  }
}

}  // namespace radive
