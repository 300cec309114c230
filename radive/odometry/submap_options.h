// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "radive/util/option_field.h"

namespace radive {

// Which scans become keyframes, and what the submap keeps of them.
struct SubmapOptions {
  enum class Type {
    kRaw,  // the points of the last keyframes
    kSdf,  // surface points of a neural map of them
  };
  Type type = Type::kRaw;

  double keyframe_distance = 2.0;     // a keyframe every so far [m]
  double keyframe_rotation = 0.0524;  // ... or after so much turning [rad]
  int num_keyframes = 30;             // in the window

  std::vector<OptionField> Fields();
  bool IsValid(std::string* error) const { return CheckOptions("submap", *this, error); }
};

}  // namespace radive
