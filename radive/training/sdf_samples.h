// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <vector>

#include "radive/neural_map/neural_points.h"
#include "radive/training/sdf_labels.h"
#include "radive/training/sdf_training_options.h"

namespace radive {

// A position in space with the distance that the field should have there.
struct SdfSample {
  int owner = 0;                                       // neural point it was drawn about
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // map frame [m]
  SdfLabel label;
  Neighbors neighbors;  // never empty
};

// Samples about the neural points `owners`, uniform in a cube around each (paper, section "Surface
// Point Extraction"), with their labels and neighbours. Those of an owner depend on the seed, on
// `index` (of the keyframe) and on the owner's cell alone. Samples without label, with a label of
// no weight or without neighbours are left out. Ordered by owner as `owners` is.
std::vector<SdfSample> DrawSamples(const NeuralPoints& map,
                                   const std::vector<int>& owners,
                                   const SdfLabels& labels,
                                   int index,
                                   const SdfTrainingOptions& options);

// Gives the points that keyframe `index` made their axes and first feature: the local plane of the
// scans, as FirstFeature() puts it. Points without a plane keep those of the world and zeros.
void InitialisePoints(NeuralPoints* map,
                      const std::vector<int>& seen,
                      const SdfLabels& labels,
                      int index);

// Feature of a neural point on which the local surface is the plane at `offset` along `normal` (in
// the point's axes): (offset / unit, normal x, y, z, 0 ..) with world axes, and
// (offset / unit, 0 ..) with z along the normal. The decoders are trained from there.
std::vector<double> FirstFeature(const NeuralMapOptions& options,
                                 double offset,
                                 const Eigen::Vector3d& normal);

}  // namespace radive
