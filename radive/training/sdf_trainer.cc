// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/training/sdf_trainer.h"

#include <ceres/problem.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "radive/factors/eikonal_factor.h"
#include "radive/factors/feature_prior_factor.h"
#include "radive/factors/sdf_fit_cost.h"
#include "radive/factors/sdf_fit_factor.h"
#include "radive/factors/sdf_joint_cost.h"
#include "radive/neural_map/decoder_kernel.h"
#include "radive/neural_map/sdf_query.h"
#include "radive/solver/solve.h"
#include "radive/util/random.h"

namespace radive {
namespace {

bool IsFeatureFinite(const NeuralPoints& map, int k) {
  const double* feature = map.feature(k);
  return std::all_of(
      feature, feature + map.options().feature_dim, [](double x) { return std::isfinite(x); });
}

bool AreFeaturesFinite(const NeuralPoints& map, const SdfSample& sample) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(sample.neighbors.count); ++i) {
    if (!IsFeatureFinite(map, sample.neighbors.index[i])) return false;
  }
  return true;
}

// The neighbours of a sample with normalised weights.
std::vector<SdfNeighbor> NeighborsOf(const SdfSample& sample, const NeuralPoints& map) {
  std::vector<SdfNeighbor> neighbors(static_cast<std::size_t>(sample.neighbors.count));
  double weight_sum = 0.0;
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    neighbors[i].d = map.Relative(sample.neighbors.index[i], sample.position);
    neighbors[i].weight =
        NeighborWeight(sample.neighbors.squared_distance[i], map.options().softening);
    weight_sum += neighbors[i].weight;
  }
  for (SdfNeighbor& neighbor : neighbors) neighbor.weight /= weight_sum;
  return neighbors;
}

double InverseSigma(const SdfSample& sample, const SdfTrainingOptions& options) {
  return std::sqrt(sample.label.weight) / options.label_sigma;
}

ceres::Problem::Options ProblemOptions() {
  ceres::Problem::Options options;
  options.disable_all_safety_checks = true;
  options.enable_fast_removal = false;
  return options;
}

// The problem of one keyframe: adds the samples group by group.
template <int kFeature, int kHidden>
class TrainingProblem {
 public:
  using Kernel = DecoderKernel<kFeature, kHidden>;
  using Cost = SdfFitCost<kFeature, kHidden>;
  using JointCost = SdfJointCost<kFeature, kHidden>;

  // `kernel`: of the decoder as it is.
  TrainingProblem(const Kernel& kernel,
                  const SdfDecoder& decoder,
                  bool is_decoder_free,
                  const std::vector<int>& free,
                  const SdfTrainingOptions& options,
                  NeuralPoints* map)
      : kernel_(kernel),
        decoder_(decoder),
        is_decoder_free_(is_decoder_free),
        theta_(decoder.parameters()),
        options_(options),
        map_(map),
        is_free_(static_cast<std::size_t>(map->size()), false),
        is_in_problem_(is_free_),
        problem_(ProblemOptions()) {
    for (const int k : free) is_free_[static_cast<std::size_t>(k)] = IsFeatureFinite(*map, k);
  }

  void Add(const std::vector<SdfSample>& samples) {
    int owner = -1;
    for (const SdfSample& sample : samples) {
      if (!AreFeaturesFinite(*map_, sample)) continue;
      if (sample.owner != owner) Flush();
      owner = sample.owner;
      AddSample(sample);
    }
    Flush();
  }

  void AddPriors() {
    if (!(options_.feature_prior_sigma > 0.0)) return;
    for (int k = 0; k < map_->size(); ++k) {
      if (!IsFree(k) || !is_in_problem_[static_cast<std::size_t>(k)]) continue;
      const double* feature = map_->feature(k);
      problem_.AddResidualBlock(
          FeaturePriorFactor::Create(std::vector<double>(feature, feature + kFeature),
                                     options_.feature_prior_sigma),
          nullptr,
          map_->feature(k));
    }
  }

  // One for each sample, on the features that are free already.
  void AddEikonal(const std::vector<SdfSample>& samples) {
    if (!(options_.eikonal_sigma > 0.0)) return;
    for (const SdfSample& sample : samples) {
      if (!AreFeaturesFinite(*map_, sample)) continue;
      std::vector<EikonalNeighbor> neighbors;
      std::vector<double*> blocks;
      for (std::size_t i = 0; i < static_cast<std::size_t>(sample.neighbors.count); ++i) {
        const NeuralPoint& point = map_->point(sample.neighbors.index[i]);
        neighbors.push_back({sample.position - point.position, point.orientation});
        blocks.push_back(map_->feature(sample.neighbors.index[i]));
      }
      for (double* block : blocks) problem_.AddParameterBlock(block, kFeature);
      blocks.push_back(theta_.data());
      problem_.AddResidualBlock(EikonalFactor::Create(decoder_,
                                                      map_->options().resolution,
                                                      neighbors,
                                                      map_->options().softening,
                                                      0.5 * map_->options().resolution,
                                                      options_.eikonal_sigma),
                                nullptr,
                                blocks);
      HoldConstant(sample);
    }
  }

  TrainingResult Solve() {
    TrainingResult result;
    result.num_samples = num_samples_;
    for (int k = 0; k < map_->size(); ++k) {
      if (IsFree(k) && is_in_problem_[static_cast<std::size_t>(k)]) ++result.num_free_points;
    }
    if (num_samples_ == 0) return result;
    const SolveSummary summary = radive::Solve(options_.solver, &problem_);
    result.usable = summary.usable;
    result.num_iterations = summary.num_iterations;
    return result;
  }

  const std::vector<double>& theta() const { return theta_; }

 private:
  bool IsFree(int k) const { return is_free_[static_cast<std::size_t>(k)]; }
  // What a point contributes to a sample changes in the training.
  bool IsVariable(int k) const { return is_decoder_free_ || IsFree(k); }

  // Of the blocks of a sample that are in the problem, those that training leaves alone.
  void HoldConstant(const SdfSample& sample) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(sample.neighbors.count); ++i) {
      const int k = sample.neighbors.index[i];
      if (!IsFree(k)) problem_.SetParameterBlockConstant(map_->feature(k));
    }
    if (!is_decoder_free_) problem_.SetParameterBlockConstant(theta_.data());
  }

  void AddFactor(const SdfSample& sample, const std::vector<SdfNeighbor>& neighbors) {
    std::vector<double*> blocks;
    for (std::size_t i = 0; i < neighbors.size(); ++i) {
      const int k = sample.neighbors.index[i];
      blocks.push_back(map_->feature(k));
      is_in_problem_[static_cast<std::size_t>(k)] = true;
    }
    blocks.push_back(theta_.data());
    problem_.AddResidualBlock(SdfFitFactor::Create(decoder_,
                                                   map_->options().resolution,
                                                   neighbors,
                                                   sample.label.distance,
                                                   1.0 / InverseSigma(sample, options_)),
                              nullptr,
                              blocks);
    HoldConstant(sample);
    ++num_samples_;
  }

  void AddSample(const SdfSample& sample) {
    const std::vector<SdfNeighbor> neighbors = NeighborsOf(sample, *map_);
    int num_new = 0;
    bool is_variable = false;
    for (std::size_t i = 0; i < neighbors.size(); ++i) {
      const int k = sample.neighbors.index[i];
      if (!IsVariable(k)) continue;
      is_variable = true;
      if (BlockOf(k) < 0) ++num_new;
    }
    if (!is_variable) return;
    if (options_.derivatives == SdfTrainingOptions::Derivatives::kAutodiff) {
      AddFactor(sample, neighbors);
      return;
    }
    if (static_cast<int>(group_points_.size()) + num_new > Cost::kMaxBlocks) Flush();

    SdfSampleGroup::Sample entry;
    entry.first_term = static_cast<int>(group_.terms.size());
    entry.target = sample.label.distance;
    entry.inv_sigma = InverseSigma(sample, options_);
    for (std::size_t i = 0; i < neighbors.size(); ++i) {
      const int k = sample.neighbors.index[i];
      if (!IsVariable(k)) {
        entry.target -=
            neighbors[i].weight * kernel_.Value(kernel_.Feature(map_->feature(k)), neighbors[i].d);
        continue;
      }
      int block = BlockOf(k);
      if (block < 0) {
        block = static_cast<int>(group_points_.size());
        group_points_.push_back(k);
      }
      group_.terms.push_back({block, neighbors[i].weight, neighbors[i].d});
    }
    group_.samples.push_back(entry);
    ++num_samples_;
  }

  int BlockOf(int k) const {
    for (std::size_t b = 0; b < group_points_.size(); ++b) {
      if (group_points_[b] == k) return static_cast<int>(b);
    }
    return -1;
  }

  void Flush() {
    if (!group_.samples.empty()) {
      std::vector<double*> blocks;
      for (const int k : group_points_) {
        blocks.push_back(map_->feature(k));
        is_in_problem_[static_cast<std::size_t>(k)] = true;
      }
      group_.num_blocks = static_cast<int>(blocks.size());
      if (is_decoder_free_) {
        blocks.push_back(theta_.data());
        problem_.AddResidualBlock(
            new JointCost(decoder_.activation(), map_->options().resolution, std::move(group_)),
            nullptr,
            blocks);
        for (const int k : group_points_) {
          if (!IsFree(k)) problem_.SetParameterBlockConstant(map_->feature(k));
        }
      } else {
        problem_.AddResidualBlock(new Cost(kernel_, std::move(group_)), nullptr, blocks);
      }
    }
    group_ = SdfSampleGroup();
    group_points_.clear();
  }

  const Kernel& kernel_;
  const SdfDecoder& decoder_;
  const bool is_decoder_free_;
  std::vector<double> theta_;
  const SdfTrainingOptions& options_;
  NeuralPoints* const map_;
  std::vector<bool> is_free_;
  std::vector<bool> is_in_problem_;
  ceres::Problem problem_;
  SdfSampleGroup group_;
  std::vector<int> group_points_;
  int num_samples_ = 0;
};

// `theta`: the trained parameters of the decoder; null: it is frozen.
TrainingResult Train(const std::vector<SdfSample>& samples,
                     const std::vector<int>& free,
                     const SdfDecoder& decoder,
                     const SdfTrainingOptions& options,
                     NeuralPoints* map,
                     std::vector<double>* theta) {
  return WithDecoderKernel(decoder, map->options().resolution, [&](const auto& kernel) {
    using Kernel = std::decay_t<decltype(kernel)>;
    TrainingProblem<Kernel::kFeatureDim, Kernel::kHiddenUnits> problem(
        kernel, decoder, theta != nullptr, free, options, map);
    problem.Add(samples);
    problem.AddPriors();
    problem.AddEikonal(samples);
    const TrainingResult result = problem.Solve();
    if (theta != nullptr && result.usable) *theta = problem.theta();
    return result;
  });
}

}  // namespace

TrainingResult TrainFeatures(const std::vector<SdfSample>& samples,
                             const std::vector<int>& free,
                             const SdfDecoder& decoder,
                             const SdfTrainingOptions& options,
                             NeuralPoints* map) {
  return Train(samples, free, decoder, options, map, nullptr);
}

TrainingResult TrainDecoder(const std::vector<SdfSample>& samples,
                            const std::vector<int>& free,
                            const SdfTrainingOptions& options,
                            NeuralPoints* map,
                            SdfDecoder* decoder) {
  std::vector<double> theta = decoder->parameters();
  const TrainingResult result = Train(samples, free, *decoder, options, map, &theta);
  decoder->parameters() = theta;
  return result;
}

double LabelRms(const std::vector<SdfSample>& samples,
                const NeuralPoints& map,
                const SdfDecoder& decoder) {
  if (samples.empty()) return 0.0;
  return WithDecoderKernel(decoder, map.options().resolution, [&](const auto& kernel) {
    double sum = 0.0;
    for (const SdfSample& sample : samples) {
      double value = 0.0;
      const std::vector<SdfNeighbor> neighbors = NeighborsOf(sample, map);
      for (std::size_t i = 0; i < neighbors.size(); ++i) {
        const double* feature = map.feature(sample.neighbors.index[i]);
        value += neighbors[i].weight * kernel.Value(kernel.Feature(feature), neighbors[i].d);
      }
      sum += (value - sample.label.distance) * (value - sample.label.distance);
    }
    return std::sqrt(sum / static_cast<double>(samples.size()));
  });
}

SdfDecoder RandomDecoder(int feature_dim, int hidden, SdfDecoder::Activation activation, int seed) {
  SdfDecoder decoder(feature_dim, hidden, activation);
  Random random(static_cast<std::uint64_t>(seed));
  for (double& parameter : decoder.parameters()) parameter = 0.5 * random.Normal();
  return decoder;
}

}  // namespace radive
