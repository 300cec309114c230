// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/dynamic_autodiff_cost_function.h>

#include <vector>

namespace radive {

// Feature prior factor: the feature of a neural point stays near a value.
//
//   r = (f - f_0) / sigma
//
// f      feature of the neural point                          [-]
// f_0    where it should be: what it was before the training  [-]
// sigma  standard deviation                                   [-]
//
// Parameter blocks: f (feature dimension). Residuals: as many, unit-free.
class FeaturePriorFactor {
 public:
  FeaturePriorFactor(std::vector<double> feature0, double sigma)
      : feature0_(std::move(feature0)), inv_sigma_(1.0 / sigma) {}

  template <typename T>
  bool operator()(T const* const* blocks, T* residuals) const {
    for (std::size_t i = 0; i < feature0_.size(); ++i) {
      residuals[i] = inv_sigma_ * (blocks[0][i] - feature0_[i]);
    }
    return true;
  }

  static ceres::CostFunction* Create(const std::vector<double>& feature0, double sigma) {
    auto* cost = new ceres::DynamicAutoDiffCostFunction<FeaturePriorFactor, 8>(
        new FeaturePriorFactor(feature0, sigma));
    cost->AddParameterBlock(static_cast<int>(feature0.size()));
    cost->SetNumResiduals(static_cast<int>(feature0.size()));
    return cost;
  }

 private:
  const std::vector<double> feature0_;
  const double inv_sigma_;
};

}  // namespace radive
