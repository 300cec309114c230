// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/solver/solver_options.h"
#include "radive/util/option_field.h"

namespace radive {

// How the neural map is trained at a keyframe.
struct SdfTrainingOptions {
  enum class Label {
    kUnsigned,  // distance to the nearest scan point
    kRay,       // the same distance along the nearest point's ray, positive towards the radar
    kPlane,     // to the plane of the nearest scan points, positive towards the radar
    kSmooth,    // to the plane of all neural points nearby, faded by distance, likewise signed
  };
  enum class Derivatives {
    kAnalytic,  // in closed form, sample by sample of a neural point: SdfFitCost, SdfJointCost
    kAutodiff,  // SdfFitFactor for each sample: the slow reference
  };

  Label label = Label::kSmooth;
  int label_points = 16;      // scan points a plane is fitted to
  double label_kernel = 0.5;  // standard deviation of the fading [m]
  double label_clamp = 1.0;   // labels are cut to +- this [m]
  double label_sigma = 0.2;   // standard deviation of a label [m]
  int label_window = 9;       // keyframes whose points make the labels

  int samples_per_point = 2;   // training samples about each neural point that the keyframe saw
  double sample_extent = 0.6;  // half the edge of the cube that they are drawn from [m]
  int seed = 1;

  double feature_prior_sigma = 0.5;  // features stay near where they were [-]; 0: free
  double eikonal_sigma = 0.0;        // of the gradient's length about 1 [-]; 0: no such factors

  // The decoder is trained together with the features on so many keyframes, from random weights
  // unless it was read from a file, and then frozen; 0: it is used as it was read.
  int joint_keyframes = 0;

  Derivatives derivatives = Derivatives::kAnalytic;

  // Conjugate gradients and a short first step: with Ceres' usual radius of 1e4 the first steps are
  // all rejected.
  SolverOptions solver = {
      SolverOptions::LinearSolver::kCgnr, 2, 1e-4, 1e-10, 1e-6, 1.0, 20, 0.1, 1};

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("training", *this, error); }
};

}  // namespace radive
