// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ceres/cost_function.h>
#include <glog/logging.h>

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "radive/neural_map/decoder_kernel.h"

namespace radive {

// Training samples that share their neural points, as SdfFitCost takes them.
struct SdfSampleGroup {
  struct Term {
    int block = 0;                                // which free feature
    double weight = 0.0;                          // nu_k / sum of all nu of the sample [-]
    Eigen::Vector3d d = Eigen::Vector3d::Zero();  // sample relative to the point, its axes [m]
  };
  struct Sample {
    int first_term = 0;      // its terms end where those of the next begin
    double target = 0.0;     // label less what the points with fixed features contribute [m]
    double inv_sigma = 1.0;  // [1/m]
  };

  int num_blocks = 0;
  std::vector<Sample> samples;
  std::vector<Term> terms;
};

// Many SdfFitFactors about one neural point as a single block, in closed form, with the decoder
// frozen: the same residuals and derivatives. Neighbours that training leaves alone are constants
// in the target. One block a sample costs three times as much in Ceres' bookkeeping alone.
//
// Parameter blocks: the free features (feature dimension each). Residuals: one a sample, unit-free.
template <int kFeature, int kHidden>
class SdfFitCost : public ceres::CostFunction {
 public:
  using Kernel = DecoderKernel<kFeature, kHidden>;

  // `kernel` must outlive the cost function.
  SdfFitCost(const Kernel& kernel, SdfSampleGroup group)
      : kernel_(kernel), group_(std::move(group)) {
    CHECK_LE(group_.num_blocks, kMaxBlocks);
    set_num_residuals(static_cast<int>(group_.samples.size()));
    mutable_parameter_block_sizes()->assign(static_cast<std::size_t>(group_.num_blocks), kFeature);
  }

  static constexpr int kMaxBlocks = 24;

  bool Evaluate(double const* const* features,
                double* residuals,
                double** jacobians) const override {
    typename Kernel::HiddenArray feature_parts[kMaxBlocks];
    for (int b = 0; b < group_.num_blocks; ++b) feature_parts[b] = kernel_.Feature(features[b]);
    const std::size_t num_samples = group_.samples.size();
    if (jacobians != nullptr) {
      for (int b = 0; b < group_.num_blocks; ++b) {
        if (jacobians[b] == nullptr) continue;
        Eigen::Map<Eigen::VectorXd>(jacobians[b], static_cast<Eigen::Index>(num_samples) * kFeature)
            .setZero();
      }
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
        double* jacobian = jacobians != nullptr ? jacobians[term.block] : nullptr;
        if (jacobian == nullptr) {
          value += term.weight * kernel_.Value(feature_parts[term.block], term.d);
          continue;
        }
        value += term.weight *
                 kernel_.Derivatives(feature_parts[term.block], term.d, &gradient, nullptr);
        // A neighbour occurs once a sample: its row is assigned.
        Eigen::Map<typename Kernel::FeatureVector>(jacobian + s * kFeature) =
            (sample.inv_sigma * term.weight) * gradient;
      }
      residuals[s] = sample.inv_sigma * value;
    }
    return true;
  }

 private:
  const Kernel& kernel_;
  const SdfSampleGroup group_;
};

}  // namespace radive
