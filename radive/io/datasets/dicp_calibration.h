// SPDX-FileCopyrightText: 2026 The RaDiVe authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

#include "radive/geometry/matrix_pose.h"

namespace radive {

// Takes calibration.json of a Doppler-ICP sequence apart: T_V_to_S, translation x y z [m] and
// quaternion w x y z, which despite its name maps sensor coordinates to those of the vehicle. False
// when something of it is missing or no unit quaternion.
bool ParseDicpCalibration(std::string_view text, MatrixPose* T_vehicle_sensor);

}  // namespace radive
