// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#include "radive/simulation/vehicle_style.h"

#include <glog/logging.h>

namespace radive {
namespace {

VehicleStyle Handcart() {
  VehicleStyle style;
  style.pitch = 0.02;
  style.roll = 0.02;
  style.heave = 0.008;
  style.yaw = 0.015;
  style.sway = 0.01;
  style.long_wave = 1.2;
  style.short_wave = 0.5;
  style.max_lateral_acceleration = 0.5;
  style.planned_braking = 0.5;
  style.max_acceleration = 0.6;
  style.max_braking = 1.0;
  return style;
}

}  // namespace

const VehicleStyle& StyleOf(VehicleType type) {
  static const std::vector<VehicleStyle> styles = {VehicleStyle(), Handcart()};
  const auto i = static_cast<std::size_t>(type);
  CHECK_LT(i, styles.size());
  return styles[i];
}

const std::vector<std::string>& VehicleNames() {
  static const std::vector<std::string> names = {"car", "handcart"};
  return names;
}

}  // namespace radive
