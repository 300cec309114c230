// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "radive/neural_map/neural_points.h"
#include "radive/training/sdf_samples.h"
#include "radive/training/sdf_training_options.h"

namespace radive {

// What a decoder is trained on: neural points with their first features, and samples about a part
// of them.
struct DecoderLessons {
  NeuralPoints map;
  std::vector<SdfSample> samples;
};

// Lessons from simulated streets, driven at the true poses with a dense and with a sparse radar:
// three drives of 24 keyframes each, static returns without noise. Later keyframes see surfaces
// from more scans, so samples come from all ages of a map. `map_options.decoder` is not used.
DecoderLessons MakeDecoderLessons(const NeuralMapOptions& map_options,
                                  const SdfTrainingOptions& training,
                                  int seed);

}  // namespace radive
