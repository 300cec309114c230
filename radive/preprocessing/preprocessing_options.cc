// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/preprocessing/preprocessing_options.h"

#include "radive/util/number_text.h"

namespace radive {
namespace {

// A little more than pi and pi/2, so that rounded settings pass.
constexpr double kHalfTurn = 3.1416;
constexpr double kQuarterTurn = 1.5708;

bool CheckOrder(
    const char* low_name, double low, const char* high_name, double high, std::string* error) {
  if (low < high) return true;
  *error = std::string("preprocessing.") + low_name + " must be < preprocessing." + high_name +
           ", is " + NumberText(low) + " and " + NumberText(high);
  return false;
}

}  // namespace

std::vector<OptionField> PreprocessingOptions::Fields() {
  return {
      OptionField{"min_range", &min_range, "m", "Returns nearer than this are dropped."}.AtLeast(
          0.0),
      OptionField{"max_range", &max_range, "m", "Returns farther than this are dropped."}.Above(
          0.0),
      OptionField{"min_azimuth", &min_azimuth, "rad", "Right edge of the field of view."}
          .AtLeast(-kHalfTurn)
          .AtMost(kHalfTurn),
      OptionField{"max_azimuth", &max_azimuth, "rad", "Left edge of the field of view."}
          .AtLeast(-kHalfTurn)
          .AtMost(kHalfTurn),
      OptionField{"min_elevation", &min_elevation, "rad", "Lower edge of the field of view."}
          .AtLeast(-kQuarterTurn)
          .AtMost(kQuarterTurn),
      OptionField{"max_elevation", &max_elevation, "rad", "Upper edge of the field of view."}
          .AtLeast(-kQuarterTurn)
          .AtMost(kQuarterTurn),
      OptionField{
          "azimuth_bin",
          MakeChoice(&azimuth_bin, {"off", "exact", "quantised"}),
          "-",
          "Keep only the nearest return of each direction: azimuth bins with equal elevation "
          "(as printed in the paper), or with elevation bins."},
      OptionField{"azimuth_bin_order",
                  MakeChoice(&azimuth_bin_order, {"after_velocity", "before_velocity"}),
                  "-",
                  "Whether the ego velocity is fitted to all returns, or to those that the azimuth "
                  "bins leave."},
      OptionField{"azimuth_bin_width", &azimuth_bin_width, "rad", "Width of the azimuth bins."}
          .AtLeast(1e-5)
          .AtMost(kHalfTurn),
      OptionField{"elevation_bin_width",
                  &elevation_bin_width,
                  "rad",
                  "Width of the elevation bins of azimuth_bin: quantised."}
          .AtLeast(1e-5)
          .AtMost(kHalfTurn),
  };
}

bool PreprocessingOptions::IsValid(std::string* error) const {
  return CheckOptions("preprocessing", *this, error) &&
         CheckOrder("min_range", min_range, "max_range", max_range, error) &&
         CheckOrder("min_azimuth", min_azimuth, "max_azimuth", max_azimuth, error) &&
         CheckOrder("min_elevation", min_elevation, "max_elevation", max_elevation, error);
}

}  // namespace radive
