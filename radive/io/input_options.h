// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// STAND-IN until the branch `sources` is merged.
struct InputOptions {
  enum class Format { kAuto, kXyz3, kVod7, kXyzdp5, kTj4d8, kHercules29, kRadarScenes };
  enum class DopplerSign { kAuto, kPlus, kMinus };
  Format format = Format::kAuto;
  DopplerSign doppler_sign = DopplerSign::kAuto;
  double rate = 10.0;
  int radar = 1;

  std::vector<OptionField> Fields() {
    return {
        {"format",
         MakeChoice(&format,
                    {"auto", "xyz3", "vod7", "xyzdp5", "tj4d8", "hercules29", "radarscenes"}),
         "-",
         "Layout of the scan files."},
        {"doppler_sign",
         MakeChoice(&doppler_sign, {"auto", "+1", "-1"}),
         "-",
         "Factor that makes the Doppler positive for receding returns."},
        OptionField{"rate", &rate, "Hz", "Scan rate, where the files carry no stamps."}.Above(0.0),
        OptionField{"radar", &radar, "-", "Radar of the vehicle."}.AtLeast(1).AtMost(4),
    };
  }
  bool IsValid(std::string* error) const { return CheckOptions("input", *this, error); }
};

}  // namespace radive
