// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/cost_function.h>
#include <glog/logging.h>

#include <Eigen/Core>
#include <cstddef>
#include <utility>

#include "radive/factors/sdf_fit_cost.h"
#include "radive/neural_map/decoder_kernel.h"

namespace radive {

// SdfFitCost with the decoder as one more parameter block: features and decoder are trained
// together. Same residuals and derivatives as SdfFitFactor.
//
// Parameter blocks: the features (feature dimension each), then theta (SdfDecoder::parameters()).
// Residuals: one a sample, unit-free.
template <int kFeature, int kHidden>
class SdfJointCost : public ceres::CostFunction {
 public:
  using Kernel = DecoderKernel<kFeature, kHidden>;
  static constexpr int kNumParameters = kHidden * (kFeature + 5) + 1;

  // `unit`: of length, see SdfDecoder [m].
  SdfJointCost(SdfDecoder::Activation activation, double unit, SdfSampleGroup group)
      : activation_(activation), unit_(unit), group_(std::move(group)) {
    CHECK_LE(group_.num_blocks, kMaxBlocks);
    set_num_residuals(static_cast<int>(group_.samples.size()));
    mutable_parameter_block_sizes()->assign(static_cast<std::size_t>(group_.num_blocks), kFeature);
    mutable_parameter_block_sizes()->push_back(kNumParameters);
  }

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override {
    const Kernel kernel(blocks[group_.num_blocks], activation_, unit_);
    typename Kernel::HiddenArray feature_parts[kMaxBlocks];
    for (int b = 0; b < group_.num_blocks; ++b) feature_parts[b] = kernel.Feature(blocks[b]);
    const std::size_t num_samples = group_.samples.size();
    double* by_theta = nullptr;
    if (jacobians != nullptr) {
      for (int b = 0; b < group_.num_blocks; ++b) SetZero(jacobians[b], kFeature);
      by_theta = jacobians[group_.num_blocks];
      SetZero(by_theta, kNumParameters);
    }
    typename Kernel::FeatureVector gradient;
    for (std::size_t s = 0; s < num_samples; ++s) {
      const SdfSampleGroup::Sample& sample = group_.samples[s];
      const std::size_t end = s + 1 < num_samples
                                  ? static_cast<std::size_t>(group_.samples[s + 1].first_term)
                                  : group_.terms.size();
      double value = -sample.target;
      for (std::size_t i = static_cast<std::size_t>(sample.first_term); i < end; ++i) {
        const SdfSampleGroup::Term& term = group_.terms[i];
        const typename Kernel::HiddenArray& feature_part = feature_parts[term.block];
        const double scale = sample.inv_sigma * term.weight;
        double* by_feature = jacobians != nullptr ? jacobians[term.block] : nullptr;
        value += term.weight * (by_feature != nullptr
                                    ? kernel.Derivatives(feature_part, term.d, &gradient, nullptr)
                                    : kernel.Value(feature_part, term.d));
        if (by_feature != nullptr) {
          // A neighbour occurs once a sample: its row is assigned.
          Eigen::Map<typename Kernel::FeatureVector>(by_feature + s * kFeature) = scale * gradient;
        }
        if (by_theta != nullptr) {
          kernel.AddByParameters(
              blocks[term.block], feature_part, term.d, scale, by_theta + s * kNumParameters);
        }
      }
      residuals[s] = sample.inv_sigma * value;
    }
    return true;
  }

 private:
  static constexpr int kMaxBlocks = SdfFitCost<kFeature, kHidden>::kMaxBlocks;

  void SetZero(double* jacobian, int columns) const {
    if (jacobian == nullptr) return;
    Eigen::Map<Eigen::VectorXd>(jacobian, Eigen::Index{num_residuals()} * columns).setZero();
  }

  const SdfDecoder::Activation activation_;
  const double unit_;
  const SdfSampleGroup group_;
};

}  // namespace radive
