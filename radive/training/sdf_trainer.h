// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/neural_map/neural_points.h"
#include "radive/neural_map/sdf_decoder.h"
#include "radive/training/sdf_samples.h"
#include "radive/training/sdf_training_options.h"

namespace radive {

// What a training did.
struct TrainingResult {
  int num_samples = 0;
  int num_free_points = 0;
  int num_iterations = 0;  // Levenberg-Marquardt steps
  bool usable = true;      // false: nothing was changed
};

// Fits the features of the points `free` (ascending) to the samples, decoder and all other features
// fixed: SdfFitCost (or SdfFitFactor, see SdfTrainingOptions::derivatives), feature priors and
// eikonal factors in one problem, solved by solver/solve.h.
// Samples that see no free point, or a feature that is not finite, are left out.
TrainingResult TrainFeatures(const std::vector<SdfSample>& samples,
                             const std::vector<int>& free,
                             const SdfDecoder& decoder,
                             const SdfTrainingOptions& options,
                             NeuralPoints* map);

// The same with the decoder as one more parameter block of the problem (SdfJointCost). `free` may
// be empty: the decoder alone.
TrainingResult TrainDecoder(const std::vector<SdfSample>& samples,
                            const std::vector<int>& free,
                            const SdfTrainingOptions& options,
                            NeuralPoints* map,
                            SdfDecoder* decoder);

// Root mean square of field less label [m]; 0 without samples.
double LabelRms(const std::vector<SdfSample>& samples,
                const NeuralPoints& map,
                const SdfDecoder& decoder);

// A decoder to start training from: small random weights.
SdfDecoder RandomDecoder(int feature_dim, int hidden, SdfDecoder::Activation activation, int seed);

}  // namespace radive
