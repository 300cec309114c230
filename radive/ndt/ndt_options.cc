// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/ndt/ndt_options.h"

namespace radive {

std::vector<OptionField> NdtOptions::Fields() {
  return {
      {"representation",
       MakeChoice(&representation, {"auto", "voxel", "point"}),
       "-",
       "What a Gaussian stands for: the points of a voxel (dense sensors), or each point with the "
       "sensor's noise (sparse sensors); auto decides by the first scan that is registered with, "
       "and run.json says how."},
      OptionField{"voxel_size", &voxel_size, "m", "Edges of a voxel along x, y and z."}
          .Above(0.0)
          .Size(3),
      OptionField{"epsilon", &epsilon, "m^2", "Added to each variance of each Gaussian."}.Above(
          0.0),
      OptionField{"min_points", &min_points, "-", "Voxels with fewer points are left out."}.AtLeast(
          1),
  };
}

}  // namespace radive
