// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/preprocessing/occlusion_options.h"

namespace radive {

std::vector<OptionField> OcclusionOptions::Fields() {
  return {
      {"enabled",
       &enabled,
       "-",
       "Whether returns behind others count less in the velocity fit and are kept out of "
       "registration. For sensors without elevation."},
      OptionField{"azimuth", &azimuth, "rad", "A return hides others within this azimuth."}.Above(
          0.0),
      OptionField{"range_ratio",
                  &range_ratio,
                  "-",
                  "A return hides others when its range is below this share of theirs."}
          .Above(0.0)
          .AtMost(1.0),
      OptionField{"range_gap", &range_gap, "m", "... and by at least this much nearer."}.AtLeast(
          0.0),
      OptionField{"max_count",
                  &max_count,
                  "-",
                  "Returns hidden by more than this many do not enter registration."}
          .AtLeast(0),
  };
}

}  // namespace radive
