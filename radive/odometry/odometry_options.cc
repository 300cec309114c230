// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/odometry_options.h"

#include "radive/neural_map/built_in_decoders.h"

namespace radive {

std::vector<std::pair<std::string, std::vector<OptionField>>> OdometryOptions::Stages() {
  return {
      {"sensor", sensor.Fields()},
      {"preprocessing", preprocessing.Fields()},
      {"occlusion", occlusion.Fields()},
      {"ego_velocity", ego_velocity.Fields()},
      {"ndt", ndt.Fields()},
      {"pairs", pairs.Fields()},
      {"registration", registration.Fields()},
      {"motion", motion.Fields()},
      {"submap", submap.Fields()},
      {"sdf_submap", sdf_submap.Fields()},
      {"neural_map", neural_map.Fields()},
      {"training", training.Fields()},
      {"surface", surface.Fields()},
  };
}

bool OdometryOptions::IsValid(std::string* error) const {
  if (!(sensor.IsValid(error) && preprocessing.IsValid(error) && occlusion.IsValid(error) &&
        ego_velocity.IsValid(error) && ndt.IsValid(error) && pairs.IsValid(error) &&
        registration.IsValid(error) && motion.IsValid(error) && submap.IsValid(error) &&
        sdf_submap.IsValid(error) && neural_map.IsValid(error) && training.IsValid(error) &&
        surface.IsValid(error))) {
    return false;
  }
  if (neural_map.decoder == nullptr && training.joint_keyframes == 0 &&
      !HasBuiltInDecoder(neural_map.feature_dim,
                         neural_map.orientation == NeuralMapOptions::Orientation::kNormal)) {
    *error =
        "neural_map.orientation identity with neural_map.feature_dim 8 must come with "
        "neural_map.decoder_file or training.joint_keyframes: no such decoder is built in";
    return false;
  }
  return true;
}

}  // namespace radive
