// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/dynamic_autodiff_cost_function.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "radive/neural_map/sdf_decoder.h"

namespace radive {

// A neural point as an eikonal sample sees it.
struct EikonalNeighbor {
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();                 // x - x_k, map axes [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  // q_k
};

// Eikonal factor: a distance field has a gradient of length one.
//
//   r = (|g| - 1) / sigma,   g_i = (S(x + step e_i) - S(x - step e_i)) / (2 step)
//
// S      field at the sample x over fixed neighbours, weights 1 / (d^2 + h^2)    [m]
// step   of the central difference, half the map's resolution for instance      [m]
// sigma  standard deviation of the gradient's length                             [-]
//
// Central differences instead of the exact gradient: they look as far as the neural points lie
// apart, and need no second derivatives. |g| is smoothed at zero, where it has none.
// Parameter blocks: f_1 .. f_K (feature dimension each), then theta. Residuals: 1, unit-free.
// Source: Gropp et al. 2020; as in PIN-SLAM, Pan et al. 2024.
class EikonalFactor {
 public:
  EikonalFactor(const SdfDecoder& decoder,
                double unit,
                std::vector<EikonalNeighbor> neighbors,
                double softening,
                double step,
                double sigma)
      : decoder_(decoder),
        unit_(unit),
        neighbors_(std::move(neighbors)),
        softening_(softening),
        step_(step),
        inv_sigma_(1.0 / sigma) {}

  template <typename T>
  bool operator()(T const* const* blocks, T* residual) const {
    using std::sqrt;
    T squared_length(1e-12);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d shift = step_ * Eigen::Vector3d::Unit(axis);
      const T slope = (Field(blocks, shift) - Field(blocks, -shift)) / (2.0 * step_);
      squared_length += slope * slope;
    }
    residual[0] = inv_sigma_ * (sqrt(squared_length) - 1.0);
    return true;
  }

  static ceres::CostFunction* Create(const SdfDecoder& decoder,
                                     double unit,
                                     const std::vector<EikonalNeighbor>& neighbors,
                                     double softening,
                                     double step,
                                     double sigma) {
    auto* cost = new ceres::DynamicAutoDiffCostFunction<EikonalFactor, 8>(
        new EikonalFactor(decoder, unit, neighbors, softening, step, sigma));
    for (std::size_t k = 0; k < neighbors.size(); ++k) {
      cost->AddParameterBlock(decoder.feature_dim());
    }
    cost->AddParameterBlock(static_cast<int>(decoder.parameters().size()));
    cost->SetNumResiduals(1);
    return cost;
  }

 private:
  template <typename T>
  T Field(T const* const* blocks, const Eigen::Vector3d& shift) const {
    T value(0.0);
    double weight_sum = 0.0;
    for (std::size_t k = 0; k < neighbors_.size(); ++k) {
      const Eigen::Vector3d offset = neighbors_[k].offset + shift;
      const double weight = 1.0 / (offset.squaredNorm() + softening_ * softening_);
      const Eigen::Matrix<T, 3, 1> d = (neighbors_[k].orientation * offset).template cast<T>();
      value += weight * decoder_.Evaluate(blocks[neighbors_.size()], blocks[k], d, unit_);
      weight_sum += weight;
    }
    return value / weight_sum;
  }

  const SdfDecoder decoder_;  // its shape; the parameters are a block
  const double unit_;
  const std::vector<EikonalNeighbor> neighbors_;
  const double softening_;
  const double step_;
  const double inv_sigma_;
};

}  // namespace radive
