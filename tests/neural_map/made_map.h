// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "radive/neural_map/neural_points.h"
#include "radive/neural_map/sdf_decoder.h"
#include "radive/util/random.h"
#include "tests/synthetic_scene.h"

// Small neural maps and decoders for the tests.

namespace radive::testing {

inline SdfDecoder RandomizedDecoder(int feature_dim,
                                    int hidden,
                                    SdfDecoder::Activation activation,
                                    int seed) {
  SdfDecoder decoder(feature_dim, hidden, activation);
  Random random(static_cast<std::uint64_t>(seed));
  for (double& parameter : decoder.parameters()) parameter = random.Normal();
  return decoder;
}

inline std::vector<MapReturn> ReturnsAt(const std::vector<Eigen::Vector3d>& positions) {
  std::vector<MapReturn> returns;
  for (const Eigen::Vector3d& position : positions) {
    MapReturn entry;
    entry.position = position;
    returns.push_back(entry);
  }
  return returns;
}

// `count` points in a cube of +-`extent` [m], random orientations and features.
inline NeuralPoints RandomMap(const NeuralMapOptions& options, int count, double extent, int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  std::vector<Eigen::Vector3d> positions;
  for (int i = 0; i < count; ++i) {
    const double x = random.Uniform(-extent, extent);
    const double y = random.Uniform(-extent, extent);
    positions.emplace_back(x, y, random.Uniform(-extent, extent));
  }
  NeuralPoints map(options);
  map.AddKeyframe(ReturnsAt(positions), 0);
  for (int k = 0; k < map.size(); ++k) {
    map.point(k).orientation = QuaternionFromRotationVector(RandomNormal3(&random));
    for (int i = 0; i < options.feature_dim; ++i) map.feature(k)[i] = random.Normal();
  }
  return map;
}

}  // namespace radive::testing
