// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/neural_map/neural_map_options.h"

#include "radive/neural_map/built_in_decoders.h"

namespace radive {

std::vector<OptionField> NeuralMapOptions::Fields() {
  return {
      OptionField{"resolution", &resolution, "m", "Edge of the cells, with one neural point each."}
          .AtLeast(0.01)
          .AtMost(10.0),
      {"position",
       MakeChoice(&position, {"first", "mean"}),
       "-",
       "Neural points lie at the first return in their cell, or at the mean of all."},
      {"orientation",
       MakeChoice(&orientation, {"identity", "normal"}),
       "-",
       "Axes of a neural point: those of the world, or z along the surface normal."},
      OptionField{"num_neighbors", &num_neighbors, "-", "Nearest neural points that are combined."}
          .AtLeast(1)
          .AtMost(kMaxSdfNeighbors),
      OptionField{"softening", &softening, "m", "h of the weight 1 / (distance^2 + h^2)."}.AtLeast(
          1e-3),
      OptionField{"noise_scale",
                  &noise_scale,
                  "m",
                  "s of a return's share s^2 / (s^2 + trace of its covariance) in the map."}
          .Above(0.0),
      OptionField{
          "max_age", &max_age, "-", "Keyframes after which an unseen neural point is forgotten."}
          .AtLeast(1),
      OptionField{"max_distance",
                  &max_distance,
                  "m",
                  "Neural points further than this from the radar are forgotten."}
          .Above(0.0),
      OptionField{"feature_dim", &feature_dim, "-", "Numbers in a feature: 4 or 8."}
          .AtLeast(4)
          .AtMost(8),
      {"decoder_file", &decoder_file, "-", "Decoder as text, see configs/; empty: built in."},
  };
}

bool NeuralMapOptions::IsValid(std::string* error) const {
  if (!CheckOptions("neural_map", *this, error)) return false;
  if (feature_dim != 4 && feature_dim != 8) {
    *error = "neural_map.feature_dim must be 4 or 8, is " + std::to_string(feature_dim);
    return false;
  }
  if (!decoder_file.empty() && decoder == nullptr) {
    *error = "neural_map.decoder_file " + decoder_file + " has not been read";
    return false;
  }
  if (decoder != nullptr && decoder->feature_dim() != feature_dim) {
    *error = "neural_map.feature_dim is " + std::to_string(feature_dim) + ", " + decoder_file +
             " has " + std::to_string(decoder->feature_dim());
    return false;
  }
  return true;
}

SdfDecoder NeuralMapOptions::Decoder() const {
  return decoder != nullptr ? *decoder
                            : BuiltInDecoder(feature_dim, orientation == Orientation::kNormal);
}

}  // namespace radive
