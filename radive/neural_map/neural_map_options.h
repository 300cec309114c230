// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "radive/neural_map/sdf_decoder.h"
#include "radive/util/option_field.h"

namespace radive {

// Neural points: where they lie, how they are combined, and how long they live.
struct NeuralMapOptions {
  enum class Position {
    kFirst,  // the first return in the cell
    kMean,   // the weighted mean of all returns in the cell so far
  };
  enum class Orientation {
    kIdentity,  // of the world frame
    kNormal,    // z along the local surface normal as first seen
  };

  double resolution = 0.5;  // edge of the cells, one neural point each [m]
  Position position = Position::kMean;
  Orientation orientation = Orientation::kNormal;
  int num_neighbors = 6;   // K of the interpolation
  double softening = 0.3;  // h of the inverse-distance weight 1 / (d^2 + h^2) [m]

  // Returns count by their noise: with s^2 / (s^2 + trace of the measurement covariance) [m]. Near
  // ones are exact; those from afar are blurred over metres.
  double noise_scale = 0.3;

  int max_age = 30;             // points not seen for so many keyframes are forgotten
  double max_distance = 120.0;  // ... and points further than this from the radar [m]

  int feature_dim = 4;       // 4 or 8
  std::string decoder_file;  // empty: the built-in decoder of that dimension

  // What decoder_file holds: whoever reads configurations fills it in. Not a setting.
  std::shared_ptr<const SdfDecoder> decoder;

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const;

  // The decoder to use: the one read, or the built-in one.
  SdfDecoder Decoder() const;
};

}  // namespace radive
