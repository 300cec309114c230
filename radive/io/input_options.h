// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// STAND-IN until the branch `sources` is merged.
struct InputOptions {
  enum class Format { kRaw, kHercules, kRadarScenes };
  enum class DopplerSign { kAuto, kPlus, kMinus };
  Format format = Format::kRaw;
  std::string layout = "xyz3";
  std::string folder;
  double rate = 10.0;
  std::string radar = "2";
  DopplerSign doppler_sign = DopplerSign::kAuto;
  bool planar = false;

  std::vector<OptionField> Fields() {
    return {
        {"format", MakeChoice(&format, {"raw", "hercules", "radarscenes"}), "-", "Kind of files."},
        {"layout", &layout, "-", "Columns of raw records."},
        {"folder", &folder, "-", "Folder with the scan files."},
        OptionField{"rate", &rate, "Hz", "Scans a second."}.Above(0.0).AtMost(1e6),
        {"radar", &radar, "-", "Which radar of the vehicle."},
        {"doppler_sign", MakeChoice(&doppler_sign, {"auto", "+1", "-1"}), "-", "Doppler factor."},
        {"planar", &planar, "-", "No elevation."},
    };
  }
  bool IsValid(std::string* error) const { return CheckOptions("input", *this, error); }
};

}  // namespace radive
