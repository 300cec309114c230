// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/dynamic_autodiff_cost_function.h>

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "radive/neural_map/sdf_decoder.h"

namespace radive {

// A neural point as a training sample sees it.
struct SdfNeighbor {
  Eigen::Vector3d d = Eigen::Vector3d::Zero();  // sample relative to the point, in its axes [m]
  double weight = 0.0;                          // nu_k / sum of all nu of the sample [-]
};

// SDF fit factor: the field at a training sample should be the sample's label.
//
//   r = (sum_k w_k D(f_k, d_k) - y) / sigma
//
// D      decoder, SdfDecoder::Evaluate with parameters theta                    [m]
// f_k    feature of the k-th of the K nearest neural points of the sample      [-]
// d_k    q_k (x - x_k) q_k^-1: the sample relative to that point               [m]
// w_k    inverse-distance weight, normalised to a sum of one                   [-]
// y      label: signed distance of the sample to the scanned surface           [m]
// sigma  standard deviation of the label                                       [m]
//
// Parameter blocks: f_1 .. f_K (feature dimension each), then theta. Residuals: 1, unit-free. With
// theta held constant the training uses SdfFitCost, the same in closed form.
// Source: RaDiVe, section "Surface Point Extraction"; Pan et al., PIN-SLAM, 2024.
class SdfFitFactor {
 public:
  SdfFitFactor(const SdfDecoder& decoder,
               double unit,
               std::vector<SdfNeighbor> neighbors,
               double label,
               double sigma)
      : decoder_(decoder),
        unit_(unit),
        neighbors_(std::move(neighbors)),
        label_(label),
        inv_sigma_(1.0 / sigma) {}

  template <typename T>
  bool operator()(T const* const* blocks, T* residual) const {
    const T* parameters = blocks[neighbors_.size()];
    T value(0.0);
    for (std::size_t k = 0; k < neighbors_.size(); ++k) {
      const Eigen::Matrix<T, 3, 1> d = neighbors_[k].d.cast<T>();
      value += neighbors_[k].weight * decoder_.Evaluate(parameters, blocks[k], d, unit_);
    }
    residual[0] = inv_sigma_ * (value - label_);
    return true;
  }

  // `unit` is the resolution of the map [m].
  static ceres::CostFunction* Create(const SdfDecoder& decoder,
                                     double unit,
                                     const std::vector<SdfNeighbor>& neighbors,
                                     double label,
                                     double sigma) {
    auto* cost = new ceres::DynamicAutoDiffCostFunction<SdfFitFactor, 8>(
        new SdfFitFactor(decoder, unit, neighbors, label, sigma));
    for (std::size_t k = 0; k < neighbors.size(); ++k) {
      cost->AddParameterBlock(decoder.feature_dim());
    }
    cost->AddParameterBlock(static_cast<int>(decoder.parameters().size()));
    cost->SetNumResiduals(1);
    return cost;
  }

 private:
  const SdfDecoder decoder_;  // its shape; the parameters are a block
  const double unit_;
  const std::vector<SdfNeighbor> neighbors_;
  const double label_;
  const double inv_sigma_;
};

}  // namespace radive
