// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/odometry/sdf_submap_options.h"

namespace radive {

std::vector<OptionField> SdfSubmapOptions::Fields() {
  return {
      {"source",
       MakeChoice(&source, {"points", "returns"}),
       "-",
       "The submap holds the surface points, or the keyframes' returns in their cells."},
      OptionField{"handover_scans",
                  &handover_scans,
                  "-",
                  "Scans after which a keyframe, trained meanwhile, enters the submap."}
          .AtLeast(0),
      {"bypass",
       &bypass,
       "-",
       "Whether a raw submap may stand in for the surface; off: the surface alone, from the first "
       "keyframe on."},
      OptionField{"bypass_keyframes",
                  &bypass_keyframes,
                  "-",
                  "Keyframes, with a raw submap, after which it is decided whether to stay raw."}
          .AtLeast(0),
      OptionField{"bypass_neighbors",
                  &bypass_neighbors,
                  "-",
                  "It stays raw when a seen neural point has fewer neighbours (median)."}
          .AtLeast(0.0),
      OptionField{"flatten", &flatten, "-", "Share by which Gaussians lose width along the normal."}
          .AtLeast(0.0)
          .AtMost(1.0),
  };
}

}  // namespace radive
