// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "radive/neural_map/neural_points.h"
#include "radive/neural_map/sdf_decoder.h"
#include "radive/training/sdf_samples.h"
#include "radive/training/sdf_training_options.h"

namespace radive {

// How a decoder to ship is trained.
struct DecoderTrainingOptions {
  int hidden = 16;
  SdfDecoder::Activation activation = SdfDecoder::Activation::kSoftsign;
  int seed = 1;
  int first_iterations = 40;  // of the decoder with the features as FirstFeature() gives them
  int rounds = 2;             // of features alone, then decoder alone
  int feature_iterations = 4;
  int decoder_iterations = 10;
};

// Trains a decoder from random weights on the samples of a map whose points have their first
// features, alternating between decoder and features; the features of the map change with it.
// `report` is told the label rms [m] after each phase; it may be empty.
SdfDecoder TrainNewDecoder(const std::vector<SdfSample>& samples,
                           const SdfTrainingOptions& training,
                           const DecoderTrainingOptions& options,
                           NeuralPoints* map,
                           const std::function<void(const std::string& phase, double rms)>& report);

}  // namespace radive
