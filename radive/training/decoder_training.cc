// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/training/decoder_training.h"

#include <algorithm>

#include "radive/training/sdf_trainer.h"

namespace radive {

SdfDecoder TrainNewDecoder(
    const std::vector<SdfSample>& samples,
    const SdfTrainingOptions& training,
    const DecoderTrainingOptions& options,
    NeuralPoints* map,
    const std::function<void(const std::string& phase, double rms)>& report) {
  SdfDecoder decoder =
      RandomDecoder(map->options().feature_dim, options.hidden, options.activation, options.seed);
  const auto tell = [&](const std::string& phase) {
    if (report) report(phase, LabelRms(samples, *map, decoder));
  };
  SdfTrainingOptions decoder_phase = training;
  decoder_phase.solver.linear_solver = SolverOptions::LinearSolver::kDenseNormalCholesky;
  decoder_phase.solver.max_iterations = options.first_iterations;
  TrainDecoder(samples, {}, decoder_phase, map, &decoder);
  tell("decoder, first features");

  // Half of the points keep their first features for good: the decoder must go on to understand
  // those, since every point of a map begins with them.
  std::vector<int> free;
  for (const SdfSample& sample : samples) {
    for (int i = 0; i < sample.neighbors.count; ++i) {
      const int k = sample.neighbors.index[static_cast<std::size_t>(i)];
      if (map->point(k).created % 2 == 0) free.push_back(k);
    }
  }
  std::sort(free.begin(), free.end());
  free.erase(std::unique(free.begin(), free.end()), free.end());
  SdfTrainingOptions feature_phase = training;
  feature_phase.solver.max_iterations = options.feature_iterations;
  decoder_phase.solver.max_iterations = options.decoder_iterations;
  for (int round = 1; round <= options.rounds; ++round) {
    TrainFeatures(samples, free, decoder, feature_phase, map);
    tell("features, round " + std::to_string(round));
    TrainDecoder(samples, {}, decoder_phase, map, &decoder);
    tell("decoder, round " + std::to_string(round));
  }
  return decoder;
}

}  // namespace radive
