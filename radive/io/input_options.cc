// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/io/input_options.h"

#include "radive/io/raw_layout.h"
#include "radive/io/scan_stamps.h"

namespace radive {

std::vector<OptionField> InputOptions::Fields() {
  return {
      OptionField{"format",
                  MakeChoice(&format, {"raw", "hercules", "radarscenes"}),
                  "-",
                  "Kind of scan files: raw float32 records, HeRCULES Continental, or RadarScenes."},
      OptionField{
          "layout",
          &layout,
          "-",
          "Columns of raw records: xyz3, vod7, xyzdp5, tj4d8, or a list of x, y, z, doppler, "
          "power and _ (ignored), such as [x,y,z,doppler,power,_,_]."},
      OptionField{"folder",
                  &folder,
                  "-",
                  "Folder with the scan files, relative to the input; empty: the usual places are "
                  "searched."},
      OptionField{"rate",
                  &rate,
                  "Hz",
                  "Scans a second, for data that store no stamps: scan k gets the stamp k / rate."}
          .AtLeast(1e-3)
          .AtMost(1e6),
      OptionField{
          "radar",
          &radar,
          "-",
          "Which radar of the vehicle, for data with several: its number from 1, or all, which "
          "makes motion.body the vehicle."},
      OptionField{"doppler_sign",
                  MakeChoice(&doppler_sign, {"auto", "+1", "-1"}),
                  "-",
                  "Factor that makes the stored Doppler a range rate, positive when moving away."},
      OptionField{"planar",
                  &planar,
                  "-",
                  "Raw records of a sensor that measures no elevation: z is set to 0."},
  };
}

bool InputOptions::IsValid(std::string* error) const {
  if (!CheckOptions("input", *this, error)) return false;
  std::string reason;
  if (!ParseRawLayout(layout, &reason)) {
    *error = "input." + reason;
    return false;
  }
  const std::optional<std::int64_t> number = ParseInteger(radar);
  if (radar != "all" && !(number && *number >= 1 && *number <= 999)) {
    *error = "input.radar must be a number from 1, or all, is '" + radar + "'";
    return false;
  }
  return true;
}

}  // namespace radive
