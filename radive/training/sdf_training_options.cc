// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/training/sdf_training_options.h"

namespace radive {

std::vector<OptionField> SdfTrainingOptions::Fields() {
  std::vector<OptionField> fields = {
      {"label",
       MakeChoice(&label, {"unsigned", "ray", "plane", "smooth"}),
       "-",
       "What a sample learns: distance to the nearest scan point, along its ray, to the plane of "
       "the nearest, or to that of the neural points nearby."},
      OptionField{"label_points", &label_points, "-", "Scan points that a plane is fitted to."}
          .AtLeast(3)
          .AtMost(64),
      OptionField{"label_kernel",
                  &label_kernel,
                  "m",
                  "Neural points count less for a smooth plane by a Gaussian of this width."}
          .Above(0.0),
      OptionField{"label_clamp", &label_clamp, "m", "Labels are cut to +- this."}.Above(0.0),
      OptionField{"label_sigma", &label_sigma, "m", "Standard deviation of a label."}.Above(0.0),
      OptionField{"label_window", &label_window, "-", "Keyframes whose points make the labels."}
          .AtLeast(1),
      OptionField{"samples_per_point",
                  &samples_per_point,
                  "-",
                  "Training samples about each neural point that the keyframe saw."}
          .AtLeast(1)
          .AtMost(100),
      OptionField{
          "sample_extent", &sample_extent, "m", "Half the edge of the cube samples come from."}
          .Above(0.0),
      OptionField{"seed", &seed, "-", "Seed of the samples."}.AtLeast(0),
      OptionField{"feature_prior_sigma",
                  &feature_prior_sigma,
                  "-",
                  "Features stay near what they were; 0: free."}
          .AtLeast(0.0),
      OptionField{"eikonal_sigma",
                  &eikonal_sigma,
                  "-",
                  "Standard deviation of the gradient's length about 1; 0: not asked for."}
          .AtLeast(0.0),
      OptionField{"joint_keyframes",
                  &joint_keyframes,
                  "-",
                  "Keyframes on which the decoder is trained with the features; 0: frozen."}
          .AtLeast(0),
      {"derivatives",
       MakeChoice(&derivatives, {"analytic", "autodiff"}),
       "-",
       "How the samples form their derivatives; autodiff is the slow reference."},
  };
  for (OptionField& field : solver.Fields()) {
    if (field.name == "linear_solver" || field.name == "max_iterations" ||
        field.name == "initial_trust_region_radius" || field.name == "max_linear_iterations") {
      fields.push_back(field);
    }
  }
  return fields;
}

}  // namespace radive
