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
class FeatureProblem {
 public:
  using Kernel = DecoderKernel<kFeature, kHidden>;
  using Cost = SdfFitCost<kFeature, kHidden>;

  FeatureProblem(const Kernel& kernel,
                 const std::vector<int>& free,
                 const SdfTrainingOptions& options,
                 NeuralPoints* map)
      : kernel_(kernel),
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
      if (!is_in_problem_[static_cast<std::size_t>(k)]) continue;
      const double* feature = map_->feature(k);
      problem_.AddResidualBlock(
          FeaturePriorFactor::Create(std::vector<double>(feature, feature + kFeature),
                                     options_.feature_prior_sigma),
          nullptr,
          map_->feature(k));
    }
  }

  // One for each sample, on the features that are free already.
  void AddEikonal(const std::vector<SdfSample>& samples, const SdfDecoder& decoder) {
    if (!(options_.eikonal_sigma > 0.0)) return;
    theta_ = decoder.parameters();
    bool is_added = false;
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
      problem_.AddResidualBlock(EikonalFactor::Create(decoder,
                                                      map_->options().resolution,
                                                      neighbors,
                                                      map_->options().softening,
                                                      0.5 * map_->options().resolution,
                                                      options_.eikonal_sigma),
                                nullptr,
                                blocks);
      for (std::size_t i = 0; i < neighbors.size(); ++i) {
        if (!is_free_[static_cast<std::size_t>(sample.neighbors.index[i])]) {
          problem_.SetParameterBlockConstant(blocks[i]);
        }
      }
      is_added = true;
    }
    if (is_added) problem_.SetParameterBlockConstant(theta_.data());
  }

  TrainingResult Solve() {
    TrainingResult result;
    result.num_samples = num_samples_;
    result.num_free_points =
        static_cast<int>(std::count(is_in_problem_.begin(), is_in_problem_.end(), true));
    if (num_samples_ == 0) return result;
    const SolveSummary summary = radive::Solve(options_.solver, &problem_);
    result.usable = summary.usable;
    result.num_iterations = summary.num_iterations;
    return result;
  }

 private:
  void AddSample(const SdfSample& sample) {
    const std::vector<SdfNeighbor>& neighbors = NeighborsOf(sample, *map_);
    int num_new = 0;
    bool sees_free = false;
    for (std::size_t i = 0; i < neighbors.size(); ++i) {
      const int k = sample.neighbors.index[i];
      if (!is_free_[static_cast<std::size_t>(k)]) continue;
      sees_free = true;
      if (BlockOf(k) < 0) ++num_new;
    }
    if (!sees_free) return;
    if (static_cast<int>(group_points_.size()) + num_new > Cost::kMaxBlocks) Flush();

    SdfSampleGroup::Sample entry;
    entry.first_term = static_cast<int>(group_.terms.size());
    entry.target = sample.label.distance;
    entry.inv_sigma = InverseSigma(sample, options_);
    for (std::size_t i = 0; i < neighbors.size(); ++i) {
      const int k = sample.neighbors.index[i];
      if (!is_free_[static_cast<std::size_t>(k)]) {
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
      problem_.AddResidualBlock(new Cost(kernel_, std::move(group_)), nullptr, blocks);
    }
    group_ = SdfSampleGroup();
    group_points_.clear();
  }

  const Kernel& kernel_;
  const SdfTrainingOptions& options_;
  NeuralPoints* const map_;
  std::vector<bool> is_free_;
  std::vector<bool> is_in_problem_;
  std::vector<double> theta_;
  ceres::Problem problem_;
  SdfSampleGroup group_;
  std::vector<int> group_points_;
  int num_samples_ = 0;
};

}  // namespace

TrainingResult TrainFeatures(const std::vector<SdfSample>& samples,
                             const std::vector<int>& free,
                             const SdfDecoder& decoder,
                             const SdfTrainingOptions& options,
                             NeuralPoints* map) {
  return WithDecoderKernel(decoder, map->options().resolution, [&](const auto& kernel) {
    using Kernel = std::decay_t<decltype(kernel)>;
    FeatureProblem<Kernel::kFeatureDim, Kernel::kHiddenUnits> problem(kernel, free, options, map);
    problem.Add(samples);
    problem.AddPriors();
    problem.AddEikonal(samples, decoder);
    return problem.Solve();
  });
}

TrainingResult TrainDecoder(const std::vector<SdfSample>& samples,
                            const std::vector<int>& free,
                            const SdfTrainingOptions& options,
                            NeuralPoints* map,
                            SdfDecoder* decoder) {
  TrainingResult result;
  std::vector<bool> is_free(static_cast<std::size_t>(map->size()), false);
  for (const int k : free) is_free[static_cast<std::size_t>(k)] = true;
  std::vector<bool> is_in_problem(is_free.size(), false);
  std::vector<double> theta = decoder->parameters();
  ceres::Problem problem(ProblemOptions());
  for (const SdfSample& sample : samples) {
    if (!AreFeaturesFinite(*map, sample)) continue;
    std::vector<double*> blocks;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sample.neighbors.count); ++i) {
      blocks.push_back(map->feature(sample.neighbors.index[i]));
      is_in_problem[static_cast<std::size_t>(sample.neighbors.index[i])] = true;
    }
    blocks.push_back(theta.data());
    problem.AddResidualBlock(SdfFitFactor::Create(*decoder,
                                                  map->options().resolution,
                                                  NeighborsOf(sample, *map),
                                                  sample.label.distance,
                                                  1.0 / InverseSigma(sample, options)),
                             nullptr,
                             blocks);
    ++result.num_samples;
  }
  if (result.num_samples == 0) return result;
  for (int k = 0; k < map->size(); ++k) {
    if (!is_in_problem[static_cast<std::size_t>(k)]) continue;
    if (is_free[static_cast<std::size_t>(k)]) {
      ++result.num_free_points;
    } else {
      problem.SetParameterBlockConstant(map->feature(k));
    }
  }
  const SolveSummary summary = Solve(options.solver, &problem);
  result.usable = summary.usable;
  result.num_iterations = summary.num_iterations;
  if (summary.usable) decoder->parameters() = theta;
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
