// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "radive/neural_map/decoder_kernel.h"
#include "radive/neural_map/neural_points.h"

namespace radive {

// The signed distance field at a position.
struct SdfValue {
  int num_neighbors = 0;  // 0: nothing is known here, and all else is zero
  double value = 0.0;     // S, positive on the side that the sensor saw [m]
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  // of S, map frame [-]
};

// Weight of a neighbour in the interpolation: the paper's 1 / d^2, softened by h, so that at a
// neural point itself the others still have a say [1/m^2].
inline double NeighborWeight(double squared_distance, double softening) {
  return 1.0 / (squared_distance + softening * softening);
}

// S(x) = sum_k nu_k D(f_k, q_k (x - x_k) q_k^-1) / sum_k nu_k over the K nearest neural points
// (paper, section "Surface Point Extraction"), with its gradient for fixed neighbours. `except`: a
// neural point that has no say, such as the one at the position itself; -1: none. `near`: the
// points near the position.
template <int kFeature, int kHidden>
SdfValue QuerySdf(const NeuralPoints& map,
                  const DecoderKernel<kFeature, kHidden>& kernel,
                  const Eigen::Vector3d& position,
                  const std::vector<NearPoint>& near,
                  int except = -1) {
  SdfValue result;
  const Neighbors neighbors = map.Nearest(near, except);
  result.num_neighbors = neighbors.count;
  const double softening = map.options().softening;
  double weight_sum = 0.0;
  Eigen::Vector3d weight_sum_gradient = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(neighbors.count); ++i) {
    const int k = neighbors.index[i];
    const NeuralPoint& point = map.point(k);
    typename DecoderKernel<kFeature, kHidden>::FeatureVector unused;
    Eigen::Vector3d by_position;
    const double distance = kernel.Derivatives(
        kernel.Feature(map.feature(k)), map.Relative(k, position), &unused, &by_position);
    const double weight = NeighborWeight(neighbors.squared_distance[i], softening);
    const Eigen::Vector3d weight_gradient = -2.0 * weight * weight * (position - point.position);
    result.value += weight * distance;
    result.gradient +=
        weight * (point.orientation.conjugate() * by_position) + distance * weight_gradient;
    weight_sum += weight;
    weight_sum_gradient += weight_gradient;
  }
  if (neighbors.count == 0) return result;
  result.value /= weight_sum;
  result.gradient = (result.gradient - result.value * weight_sum_gradient) / weight_sum;
  // A feature that is not finite says nothing.
  if (!std::isfinite(result.value) || !result.gradient.allFinite()) return SdfValue();
  return result;
}

template <int kFeature, int kHidden>
SdfValue QuerySdf(const NeuralPoints& map,
                  const DecoderKernel<kFeature, kHidden>& kernel,
                  const Eigen::Vector3d& position) {
  std::vector<NearPoint> near;
  map.FindNear(position, &near);
  return QuerySdf(map, kernel, position, near);
}

}  // namespace radive
