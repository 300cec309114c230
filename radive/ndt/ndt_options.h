// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// How points become Gaussians.
struct NdtOptions {
  enum class Representation {
    kAuto,   // kVoxel or kPoint by the first scan of the drive, see choose_representation.h
    kVoxel,  // the points of an anisotropic voxel together: dense sensors
    kPoint,  // every point for itself, with the sensor's noise: sparse sensors
  };
  Representation representation = Representation::kAuto;

  std::vector<double> voxel_size = {2.0, 2.0, 1.0};  // x, y, z [m]
  double epsilon = 0.05;                             // added to each variance [m^2]
  int min_points = 1;                                // of a voxel

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("ndt", *this, error); }

  // What is not chosen yet counts as points.
  bool IsVoxel() const { return representation == Representation::kVoxel; }
};

}  // namespace radive
