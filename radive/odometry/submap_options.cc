// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/submap_options.h"

namespace radive {

std::vector<OptionField> SubmapOptions::Fields() {
  return {
      {"type",
       MakeChoice(&type, {"raw", "sdf"}),
       "-",
       "What the submap is made of: the keyframes' points, or the surface learned from them."},
      OptionField{"keyframe_distance", &keyframe_distance, "m", "Distance between keyframes."}
          .Above(0.0),
      OptionField{"keyframe_rotation", &keyframe_rotation, "rad", "Turn between keyframes."}.Above(
          0.0),
      OptionField{
          "num_keyframes", &num_keyframes, "-", "Keyframes of each radar in the sliding window."}
          .AtLeast(1),
  };
}

}  // namespace radive
